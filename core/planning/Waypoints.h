// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/common/Camera.h"
#include "core/common/Progress.h"
#include "core/planning/CostMap.h"

namespace fodscope {

enum class VisitOrder {
    NearestNext,  ///< the paper's: from each place to the nearest waypoint that is left
    ShortestTour  ///< exact for few waypoints, else what exchanging and moving visits cannot shorten any more
};

struct WaypointSettings {
    /// Ring round the candidate, from the edge of its extent (published parameters of the paper's robot: 0.5 to
    /// 0.75 m, there from its centroid).
    double minimumDistance_m = 0.5;
    double maximumDistance_m = 0.75;
    /// The ring is widened by this share a try, inwards and outwards, until a pose is found.
    double widening = 0.1;
    int maximumTries = 10;
    /// Widening inwards ends this near to the candidate's extent, and no pose is nearer to any other candidate than
    /// the robot's radius.
    double closestDistance_m = 0.3;
    double candidateClearance_m = 0.25;
    /// A pixel covers at most so much of a candidate, anywhere on it.
    double coarsestPixel_m = 0.0015;
    /// Share of the picture's width and height that stays free at each edge: the robot stops a little off.
    double edgeMargin = 0.03;
    /// Poses on cells with at least this cost, of 100, collide (paper's robot: 85).
    double costThresholdPercent = 85.0;
    /// Step of the candidate poses along the ring and across it.
    double angleStep_rad = radiansFromDegrees(5.0);
    double distanceStep_m = 0.05;
    /// Ray step in cells (paper's robot: 0.02 of a 1 cm cell; coarser grids need no finer step).
    double rayStep_cells = 0.25;
    VisitOrder order = VisitOrder::ShortestTour;

    bool operator==(const WaypointSettings&) const = default;
};

/// What the planner needs to know of a candidate.
struct PlanTarget {
    std::string candidateId;
    Eigen::Vector3d centroid_map = Eigen::Vector3d::Zero();
    /// Length, width, height.
    Eigen::Vector3d size_m = Eigen::Vector3d::Zero();
    /// Direction of the length in the map frame.
    double lengthDirection_rad = 0.0;
    /// Centres of its voxels: x and y in the map frame, z over the floor. Without any the candidate is a box.
    std::vector<Eigen::Vector3d> voxels;
    double voxelSize_m = 0.02;
};

/// Unreachable: poses that see the target are where the robot cannot get to; Hidden: no pose sees it; TooHigh, TooNear,
/// TooFar: from no place in reach is it whole in the picture, or its pixels are too coarse; LeftOut: the operator's
/// plan has none.
enum class WaypointStatus { Ok, Unreachable, Hidden, TooCloseToWall, OutsideGrid, TooHigh, TooNear, TooFar, LeftOut };

/// @return "ok" or the reason in the words of the file contract
std::string toString(WaypointStatus status);

/// A robot pose from which candidates are photographed.
struct Waypoint {
    /// "W-01" in visit order; candidates without a pose come last.
    std::string id;
    /// Those that its photo is taken for: each is whole in the picture, or a part of it that other photos complete.
    std::vector<std::string> candidateIds;
    /// Empty when there is none; `status` tells why.
    std::optional<Pose2> pose_map;
    /// Cost summed along the lines of sight.
    double cost = 0.0;
    WaypointStatus status = WaypointStatus::Unreachable;
    /// Drive from the previous waypoint (or the robot), map frame.
    DrivePath drive;
    /// False: the robot only passes by, as on an inspection route.
    bool takesPhoto = true;
};

/// How much of a candidate the photos of a plan show together.
struct CandidateView {
    std::string candidateId;
    /// Of its voxels.
    double share = 0.0;
    /// Why no photo shows the rest; Ok when there is no rest.
    WaypointStatus rest = WaypointStatus::Ok;

    bool operator==(const CandidateView&) const = default;
};

/// Waypoints in visit order. `length_m` is the drive over all of them along the cost map.
struct VisitPlan {
    std::vector<Waypoint> waypoints;
    double length_m = 0.0;
    Pose2 start_map;
    /// Drives over the same waypoints in either order; empty where they are not known (plans of older sessions).
    std::optional<double> nearestNextLength_m;
    std::optional<double> shortestTourLength_m;
    /// One for each candidate, in the targets' order; none in plans of older sessions.
    std::vector<CandidateView> views;
};

/// Ring of poses round each target, collision test against the inflated cost, line of sight through the FOD-less cost
/// map, least summed cost wins (ties: the smaller angle, then the smaller distance), facing the target; then the visit
/// order. Paper: "Waypoint Generation". Deterministic: no random sampling.
///
/// Beyond the paper: the ring starts at the target's extent; the whole target has to be in the picture of the camera,
/// sharp and at a usable pixel size; a target that no pose shows whole is divided until its parts are shown, and what
/// is left over is told in `views`. A pose may show several targets (or parts): the plan is one with the fewest photos,
/// and among those with the least cost.
///
/// Every target is in a waypoint; ids run in visit order, and targets without a pose follow at the end in their order.
/// A line of sight is blocked by lethal cells alone. It ends one cell before the target's near side, not at its
/// centroid: every way from its centroid a target reaches at least half its width, so that one that leans on a wall
/// (its centroid lies in the wall's cells) can be photographed. Unknown cells block no view, for nothing is known to
/// stand there, but cost as much as inscribed ones, so that views over known floor are preferred.
/// @param collision cost map of the full grid, flood filled from the robot
/// @param sight cost map of the FOD-less grid on the same lattice
/// @throws Error when the two differ in lattice, the collision map was not flood filled, or a setting is out of range;
///         Cancelled
VisitPlan planVisits(std::span<const PlanTarget> targets, const CostMap& collision, const CostMap& sight,
                     const Pose2& robot_map, const WaypointSettings& settings, const CameraSettings& camera,
                     Progress& progress);

/// `waypoints.json` of the file contract: equal plans give an equal text. Pose and cost are null where there is none.
std::string waypointsJson(const VisitPlan& plan);

}  // namespace fodscope
