// SPDX-License-Identifier: MIT
#include "core/inspection/BoxOwners.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <span>

#include "core/inspection/PhotoProjection.h"

namespace fodscope {
namespace {

struct Outline {
    std::string candidateId;
    std::vector<cv::Point2f> hull_px;
    double depth_m = 0.0;
    /// Whether the photo was taken for it.
    bool isSubject = false;
};

bool holds(const std::vector<std::string>& ids, const std::string& id) {
    return std::ranges::find(ids, id) != ids.end();
}

Outline outlineOf(const Candidate& candidate, const DetectionRecord& detection, const Photo& photo) {
    const ProjectedVoxels projected =
        projectVoxels(voxelsInMap(candidate, detection), detection.parameters.discrepancy.voxelSize_m,
                      photo.T_map_from_camera, photo.intrinsics);
    Outline outline{candidate.id, {}, projected.nearestDepth_m, holds(photo.candidateIds, candidate.id)};
    for (const Eigen::Vector2d& corner : projected.hull_px)
        outline.hull_px.emplace_back(static_cast<float>(corner.x()), static_cast<float>(corner.y()));
    return outline;
}

/// @return how much of the smaller of the two lies in the other, 0 to 1
double overlap(const Outline& outline, const PixelBox& box) {
    if (outline.hull_px.size() < 3) return 0.0;
    const auto left = static_cast<float>(box.left_px);
    const auto top = static_cast<float>(box.top_px);
    const auto right = static_cast<float>(box.left_px + box.width_px);
    const auto bottom = static_cast<float>(box.top_px + box.height_px);
    const std::vector<cv::Point2f> rectangle{{left, top}, {right, top}, {right, bottom}, {left, bottom}};
    std::vector<cv::Point2f> common;
    const double smaller = std::min(cv::contourArea(outline.hull_px), box.width_px * box.height_px);
    const double shared = cv::intersectConvexConvex(outline.hull_px, rectangle, common);
    return smaller > 0.0 && shared > 0.0 ? shared / smaller : 0.0;
}

std::vector<std::string> ownersOf(const PixelBox& box, const std::vector<Outline>& outlines, const Photo& photo) {
    std::vector<std::pair<double, std::string>> subjects;
    const Outline* nearest = nullptr;
    double most = 0.0;
    for (const Outline& outline : outlines) {
        const double share = overlap(outline, box);
        if (share == 0.0) continue;
        if (outline.isSubject) {
            subjects.emplace_back(share, outline.candidateId);
            most = std::max(most, share);
        }
        if (nearest == nullptr || outline.depth_m < nearest->depth_m) nearest = &outline;
    }
    // A box round one of two neighbours touches the other's outline too.
    std::vector<std::string> owners;
    for (const auto& [share, id] : subjects)
        if (2.0 * share >= most) owners.push_back(id);
    if (!owners.empty()) return owners;
    return nearest != nullptr ? std::vector<std::string>{nearest->candidateId} : photo.candidateIds;
}

/// Of what was planned to be shown of a candidate in several photos: a robot stops a little off.
constexpr double kMostOfIt = 0.9;

/// Whether the plan takes more than one photo for the candidate.
bool isShownInParts(const std::string& candidateId, const InspectionState& state) {
    if (!state.plan) return false;
    return std::ranges::count_if(state.plan->waypoints, [&](const Waypoint& waypoint) {
               return waypoint.pose_map && holds(waypoint.candidateIds, candidateId);
           }) > 1;
}

double plannedShare(const std::string& candidateId, const InspectionState& state) {
    const auto& views = state.plan->views;
    const auto view = std::ranges::find(views, candidateId, &CandidateView::candidateId);
    return view == views.end() ? 1.0 : view->share;
}

bool hasBox(const Decision& decision) {
    return std::ranges::any_of(decision.labels, [](const PhotoLabel& label) { return label.box.has_value(); });
}

}  // namespace

std::vector<OwnedDecision> ownDecisions(const InspectionState& state) {
    std::vector<OwnedDecision> owned;
    for (const Decision& decision : state.decisions) {
        OwnedDecision entry{&decision, {}};
        const Photo* photo = findPhoto(state, decision.photoId);
        if (photo == nullptr) continue;
        std::vector<Outline> outlines;
        if (hasBox(decision) && state.detection && state.detection->field && state.detection->candidates) {
            for (const Candidate& candidate : state.detection->candidates->candidates)
                outlines.push_back(outlineOf(candidate, *state.detection, *photo));
        }
        for (const PhotoLabel& label : decision.labels)
            entry.owners.push_back(label.box ? ownersOf(*label.box, outlines, *photo) : photo->candidateIds);
        owned.push_back(std::move(entry));
    }
    return owned;
}

std::vector<const Photo*> photosThatShow(const std::string& candidateId, const InspectionState& state) {
    std::vector<const Photo*> photos;
    for (const Photo& photo : state.photos)
        if (holds(photo.candidateIds, candidateId)) photos.push_back(&photo);
    if (!state.detection || !state.detection->field || !state.detection->candidates) return photos;
    const auto& candidates = state.detection->candidates->candidates;
    const auto candidate = std::ranges::find(candidates, candidateId, &Candidate::id);
    if (candidate == candidates.end() || candidate->voxels.empty()) return photos;

    const std::vector<Eigen::Vector3d> voxels_map = voxelsInMap(*candidate, *state.detection);
    const bool hasParts = isShownInParts(candidateId, state);
    std::vector<std::uint8_t> isShown(voxels_map.size(), 0);
    std::erase_if(photos, [&](const Photo* photo) {
        std::size_t voxels = 0;
        for (std::size_t i = 0; i < voxels_map.size(); ++i) {
            if (!isInPhoto(voxels_map[i], photo->T_map_from_camera, photo->intrinsics)) continue;
            isShown[i] = 1;
            ++voxels;
        }
        return hasParts ? voxels == 0 : 2 * voxels < voxels_map.size();
    });
    const auto shown = static_cast<double>(std::ranges::count(isShown, 1));
    if (hasParts && shown < kMostOfIt * plannedShare(candidateId, state) * static_cast<double>(voxels_map.size()))
        photos.clear();
    return photos;
}

std::pair<std::vector<PhotoSubject>, std::vector<Decision>> wordsOn(const std::string& candidateId,
                                                                    const InspectionState& state,
                                                                    const std::vector<OwnedDecision>& owned) {
    std::vector<PhotoSubject> photos;
    std::vector<Decision> decisions;
    const std::vector<const Photo*> shownOn = photosThatShow(candidateId, state);
    for (const Photo& photo : state.photos) {
        const bool isSubject = std::ranges::find(shownOn, &photo) != shownOn.end();
        const std::size_t before = decisions.size();
        for (const OwnedDecision& entry : owned) {
            if (entry.decision->photoId != photo.id) continue;
            Decision words = *entry.decision;
            words.labels.clear();
            for (std::size_t i = 0; i < entry.owners.size(); ++i) {
                const PhotoLabel& label = entry.decision->labels[i];
                const bool clears = kindOf(state.labelSet, label.label) == LabelKind::NoFod;
                if (holds(entry.owners[i], candidateId) && (isSubject || !clears)) words.labels.push_back(label);
            }
            if (words.labels.empty() && !entry.decision->labels.empty() && isSubject)
                words.labels.push_back({kNoFod, std::nullopt});
            decisions.push_back(std::move(words));
        }
        // A photo taken for others tells of the candidate as long as a reader's last word on it does.
        const std::span said(decisions.data() + before, decisions.size() - before);
        if (isSubject || !countingDecisions(said, photo.id).empty()) photos.push_back({photo.id, {candidateId}});
    }
    return {std::move(photos), std::move(decisions)};
}

}  // namespace fodscope
