// SPDX-License-Identifier: MIT
#include "core/inspection/BoxOwners.h"

#include <algorithm>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <span>

namespace fodscope {
namespace {

/// Nearer points would project to anywhere.
constexpr double kNearestDepth_m = 0.02;

struct Outline {
    std::string candidateId;
    std::vector<cv::Point2f> hull_px;
    double depth_m = std::numeric_limits<double>::infinity();
    /// Whether the photo was taken for it.
    bool isSubject = false;
};

bool holds(const std::vector<std::string>& ids, const std::string& id) {
    return std::ranges::find(ids, id) != ids.end();
}

/// The hull of the candidate's voxel cubes in the photo.
Outline outlineOf(const Candidate& candidate, const DetectionRecord& detection, const Photo& photo) {
    Outline outline{candidate.id, {}, std::numeric_limits<double>::infinity(), holds(photo.candidateIds, candidate.id)};
    const Transform T_camera_from_reference =
        photo.T_map_from_camera.inverse() * detection.registration.T_reference_from_map.inverse();
    const double half_m = detection.parameters.discrepancy.voxelSize_m / 2.0;
    std::vector<cv::Point2f> corners_px;
    for (const std::uint32_t voxel : candidate.voxels) {
        if (voxel >= detection.field->points.size()) continue;
        for (int corner = 0; corner < 8; ++corner) {
            const Eigen::Vector3d step((corner & 1) ? half_m : -half_m, (corner & 2) ? half_m : -half_m,
                                       (corner & 4) ? half_m : -half_m);
            const Eigen::Vector3d point_camera = T_camera_from_reference * (detection.field->points[voxel] + step);
            if (!(point_camera.z() > kNearestDepth_m)) continue;
            outline.depth_m = std::min(outline.depth_m, point_camera.z());
            const CameraIntrinsics& k = photo.intrinsics;
            corners_px.emplace_back(static_cast<float>(k.fx_px * point_camera.x() / point_camera.z() + k.cx_px),
                                    static_cast<float>(k.fy_px * point_camera.y() / point_camera.z() + k.cy_px));
        }
    }
    if (corners_px.size() >= 3) cv::convexHull(corners_px, outline.hull_px);
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
    const Transform T_camera_from_reference =
        photo.T_map_from_camera.inverse() * state.detection->registration.T_reference_from_map.inverse();
    const auto& points = state.detection->field->points;
    const CameraIntrinsics& k = photo.intrinsics;
    const auto inside = std::ranges::count_if(candidate->voxels, [&](std::uint32_t voxel) {
        if (voxel >= points.size()) return false;
        const Eigen::Vector3d point_camera = T_camera_from_reference * points[voxel];
        if (!(point_camera.z() > kNearestDepth_m)) return false;
        const double column_px = k.fx_px * point_camera.x() / point_camera.z() + k.cx_px;
        const double row_px = k.fy_px * point_camera.y() / point_camera.z() + k.cy_px;
        return column_px >= 0.0 && row_px >= 0.0 && column_px < k.width_px && row_px < k.height_px;
    });
    return 2 * static_cast<std::size_t>(inside) >= candidate->voxels.size();
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
