// SPDX-License-Identifier: MIT
#pragma once

#include "core/planning/Waypoints.h"

namespace fodscope {

/// A pose that the operator wants a photo from.
struct PlannedStop {
    Pose2 pose_map;
    /// What the photo is taken for; without any, every candidate that it shows a good part of.
    std::vector<std::string> candidateIds;
};

/// @return the stops of a plan, in visit order, as the operator may change them
std::vector<PlannedStop> stopsOf(const VisitPlan& plan);

/// A plan over the operator's own stops, in the operator's order: drives, lengths, what each photo is taken for and how
/// much of each candidate they show together. Candidates that no stop shows are listed as left out by the operator, or
/// with the reason that the plan before gave where it had no pose for them either.
/// @param before the plan that was changed
/// @throws Error naming a stop where the robot cannot stand or that it cannot get to, and as planVisits(); Cancelled
VisitPlan planOfStops(std::span<const PlannedStop> stops, std::span<const PlanTarget> targets, const CostMap& collision,
                      const CostMap& sight, const VisitPlan& before, const WaypointSettings& settings,
                      const CameraSettings& camera, Progress& progress);

}  // namespace fodscope
