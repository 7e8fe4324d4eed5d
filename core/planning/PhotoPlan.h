// SPDX-License-Identifier: MIT
#pragma once

#include "core/planning/WaypointSearch.h"

namespace fodscope {

/// A pose and what its photo is taken for.
struct PhotoPose {
    Pose2 pose_map;
    /// Summed over the lines of sight.
    double cost = 0.0;
    /// Indices of the targets, ascending.
    std::vector<std::size_t> targets;
};

struct PhotoPlan {
    /// In no visit order.
    std::vector<PhotoPose> poses;
    /// One for each target.
    std::vector<CandidateView> views;
};

/// The fewest poses that show all that can be shown of the targets.
/// @throws Cancelled
PhotoPlan planPhotos(std::span<const PlanTarget> targets, const SearchFloor& floor, const CameraFit& camera,
                     const WaypointSettings& settings, Progress& progress);

}  // namespace fodscope
