// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <QString>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/inspection/InspectionState.h"
#include "core/planning/CostMap.h"
#include "core/planning/Waypoints.h"
#include "core/robot/VisitRunner.h"

namespace fodscope {

struct PlanCandidate {
    std::string id;
    Eigen::Vector2d centroid_map = Eigen::Vector2d::Zero();
    /// Half of the diagonal of its footprint, metres.
    double radius_m = 0.05;
    Verdict verdict = Verdict::NotPhotographed;
    /// Why no waypoint photographs it, or not all of it; empty when all of it is, or when nothing is planned yet.
    std::string noWaypointReason;
    /// Share of it that the plan's photos show; 0 without a plan.
    double plannedShare = 0.0;
};

struct PlanWaypoint {
    std::string id;
    /// 1, 2, … in visit order.
    int number = 0;
    std::vector<std::string> candidateIds;
    Pose2 pose_map;
    bool takesPhoto = true;
    VisitState state = VisitState::Draft;
    std::string reason;
    /// Drive that leads to it.
    std::vector<Eigen::Vector2d> drive_map;
};

/// Where the robot is, and how old that is.
struct PlanRobot {
    Pose2 pose_map;
    double poseAge_s = 0.0;
};

/// What the plan shows, all in the map frame.
struct PlanScene {
    /// Null until there is a grid.
    std::shared_ptr<const CostMap> costMap;
    /// The map's voxels seen from above; drawn where there is no grid.
    std::vector<Eigen::Vector2d> pointsFromAbove_map;
    std::vector<PlanCandidate> candidates;
    std::vector<PlanWaypoint> waypoints;
    double length_m = 0.0;
    std::optional<Pose2> start_map;
    /// A route whose poses can be moved; without candidates.
    bool isRoute = false;
    /// The photo camera's view.
    double viewAngle_rad = CameraSettings().horizontalFieldOfView_rad;
    double viewRange_m = 0.75;
};

/// The plan of an inspection. Makes the cost map from its grid; that takes some 10 ms on a tank.
PlanScene planScene(const InspectionState& state);

/// The inspection route on a grid, which may be null.
PlanScene routeScene(const InspectionState& state, const OccupancyGrid* grid_map);

/// The visits' states put into a scene, without making the cost map anew.
void updateVisits(PlanScene& scene, const std::vector<Visit>& visits);

}  // namespace fodscope
