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

bool meets(const Outline& outline, const PixelBox& box) {
    if (outline.hull_px.size() < 3) return false;
    const auto left = static_cast<float>(box.left_px);
    const auto top = static_cast<float>(box.top_px);
    const auto right = static_cast<float>(box.left_px + box.width_px);
    const auto bottom = static_cast<float>(box.top_px + box.height_px);
    const std::vector<cv::Point2f> rectangle{{left, top}, {right, top}, {right, bottom}, {left, bottom}};
    std::vector<cv::Point2f> common;
    return cv::intersectConvexConvex(outline.hull_px, rectangle, common) > 0.0F;
}

std::vector<std::string> ownersOf(const PixelBox& box, const std::vector<Outline>& outlines, const Photo& photo) {
    std::vector<std::string> subjects;
    const Outline* nearest = nullptr;
    for (const Outline& outline : outlines) {
        if (!meets(outline, box)) continue;
        if (outline.isSubject) subjects.push_back(outline.candidateId);
        if (nearest == nullptr || outline.depth_m < nearest->depth_m) nearest = &outline;
    }
    if (!subjects.empty()) return subjects;
    return nearest != nullptr ? std::vector<std::string>{nearest->candidateId} : photo.candidateIds;
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

bool shows(const Photo& photo, const std::string& candidateId, const InspectionState& state) {
    if (!state.detection || !state.detection->field || !state.detection->candidates) return true;
    const auto& candidates = state.detection->candidates->candidates;
    const auto candidate = std::ranges::find(candidates, candidateId, &Candidate::id);
    if (candidate == candidates.end() || candidate->voxels.empty()) return true;
    const ProjectedVoxels projected =
        projectVoxels(voxelsInMap(*candidate, *state.detection), state.detection->parameters.discrepancy.voxelSize_m,
                      photo.T_map_from_camera, photo.intrinsics);
    return 2 * projected.centresInImage >= candidate->voxels.size();
}

std::pair<std::vector<PhotoSubject>, std::vector<Decision>> wordsOn(const std::string& candidateId,
                                                                    const InspectionState& state,
                                                                    const std::vector<OwnedDecision>& owned) {
    std::vector<PhotoSubject> photos;
    std::vector<Decision> decisions;
    for (const Photo& photo : state.photos) {
        const bool isSubject = holds(photo.candidateIds, candidateId) && shows(photo, candidateId, state);
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
