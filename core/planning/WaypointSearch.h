// SPDX-License-Identifier: MIT
#pragma once

#include "core/planning/Waypoints.h"

namespace fodscope {

/// The best pose to photograph one target from, or the reason why there is none.
struct WaypointChoice {
    WaypointStatus status = WaypointStatus::Unreachable;
    std::optional<Pose2> pose_map;
    double cost = 0.0;
};

/// Looks round the ring, and round wider ones until a pose is found.
WaypointChoice chooseWaypoint(const PlanTarget& target, const CostMap& collision, const CostMap& sight,
                              const WaypointSettings& settings);

/// Cost summed along the line of sight from a place towards a target, one term a step; empty when a lethal cell
/// interrupts it.
std::optional<double> costOfSight(const Eigen::Vector2d& place_map, const PlanTarget& target, const CostMap& sight,
                                  double rayStep_cells);

}  // namespace fodscope
