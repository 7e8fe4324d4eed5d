// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/common/Progress.h"
#include "core/planning/CostMap.h"

namespace fodscope {

struct WaypointSettings {
    /// Ring round the candidate, from its centroid (published parameters of the paper's robot: 0.5 to 0.75 m).
    double minimumDistance_m = 0.5;
    double maximumDistance_m = 0.75;
    /// The ring is widened by this share a try, inwards and outwards, until a pose is found.
    double widening = 0.1;
    int maximumTries = 10;
    /// Widening inwards ends where the candidate's near end comes this close: nearer, the photo camera (0.20 m up, 5°
    /// down, 42° high) does not see the floor.
    double closestDistance_m = 0.42;
    /// Poses on cells with at least this cost, of 100, collide (paper's robot: 85).
    double costThresholdPercent = 85.0;
    /// Step of the candidate poses along the ring and across it.
    double angleStep_rad = radiansFromDegrees(5.0);
    double distanceStep_m = 0.05;
    /// Ray step in cells (paper's robot: 0.02 of a 1 cm cell; coarser grids need no finer step).
    double rayStep_cells = 0.25;

    bool operator==(const WaypointSettings&) const = default;
};

/// What the planner needs to know of a candidate.
struct PlanTarget {
    std::string candidateId;
    Eigen::Vector3d centroid_map = Eigen::Vector3d::Zero();
    Eigen::Vector3d size_m = Eigen::Vector3d::Zero();
};

/// Unreachable: poses that see the target are where the robot cannot get to; Hidden: no pose sees it.
enum class WaypointStatus { Ok, Unreachable, Hidden, TooCloseToWall, OutsideGrid };

/// @return "ok" or the reason in the words of the file contract
std::string toString(WaypointStatus status);

/// A robot pose from which a candidate is photographed.
struct Waypoint {
    /// "W-01" in visit order; candidates without a pose come last.
    std::string id;
    std::vector<std::string> candidateIds;
    /// Empty when there is none; `status` tells why.
    std::optional<Pose2> pose_map;
    /// Cost summed along the line of sight.
    double cost = 0.0;
    WaypointStatus status = WaypointStatus::Unreachable;
    /// Drive from the previous waypoint (or the robot), map frame.
    DrivePath drive;
    /// False: the robot only passes by, as on an inspection route.
    bool takesPhoto = true;
};

/// Waypoints in visit order. `length_m` is the drive over all of them along the cost map.
struct VisitPlan {
    std::vector<Waypoint> waypoints;
    double length_m = 0.0;
    Pose2 start_map;
};

/// Ring of poses round each target, collision test against the inflated cost, line of sight through the FOD-less cost
/// map, least summed cost wins (ties: the smaller angle, then the smaller distance), facing the target; then
/// nearest-next order by travel distance. Paper: "Waypoint Generation". Deterministic: no random sampling.
/// Every target gets a waypoint; ids run in visit order, and targets without a pose follow at the end in their order.
/// A line of sight is blocked by lethal cells alone. It ends one cell before the candidate's near side, not at its
/// centroid: every way from its centroid a candidate reaches at least half its width, so that one that leans on a wall
/// (its centroid lies in the wall's cells) can be photographed. Unknown cells block no view, for nothing is known to
/// stand there, but cost as much as inscribed ones, so that views over known floor are preferred.
/// @param collision cost map of the full grid, flood filled from the robot
/// @param sight cost map of the FOD-less grid on the same lattice
/// @throws Error when the two differ in lattice, the collision map was not flood filled, or a setting is out of range;
///         Cancelled
VisitPlan planVisits(std::span<const PlanTarget> targets, const CostMap& collision, const CostMap& sight,
                     const Pose2& robot_map, const WaypointSettings& settings, Progress& progress);

/// `waypoints.json` of the file contract: equal plans give an equal text. Pose and cost are null where there is none.
std::string waypointsJson(const VisitPlan& plan);

}  // namespace fodscope
