// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/robot/Photo.h"
#include "core/robot/Visit.h"

namespace fodscope {

/// What is wrong with a step of a visit.
struct VisitProblem {
    VisitReason reason = VisitReason::None;
    std::string detail;
};

/// @return whether every number of the pose is one
bool isFinite(const Pose2& pose);

/// @return how far the robot stands from its goal, where that is too far
std::optional<VisitProblem> arrivalProblem(const Pose2& stands_map, const Pose2& goal_map,
                                           const VisitSettings& settings);

/// What a photo must fit.
struct PhotoExpectation {
    std::string waypointId;
    Pose2 pose_map;
    /// On this computer's clock.
    UtcTime arrived;
    UtcTime now;
    /// The robot's clock minus this computer's, where it is known.
    double clockOffset_s = 0.0;
    /// Fingerprints of the photos that came before.
    const std::vector<PhotoMark>* kept = nullptr;
};

/// Looks whether a photo may be the one of a visit: whole, taken at its waypoint, since the robot arrived, showing
/// something, and none that came before. Fills in its media type and its fingerprint.
std::optional<VisitProblem> photoProblem(Photo& photo, const PhotoExpectation& expected, const VisitSettings& settings);

}  // namespace fodscope
