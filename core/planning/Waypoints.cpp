// SPDX-License-Identifier: MIT
#include "core/planning/Waypoints.h"

#include <algorithm>

#include "core/planning/PhotoPlan.h"
#include "core/planning/PlanChecks.h"
#include "core/planning/VisitOrder.h"

namespace fodscope {
namespace {

/// Puts the poses into visit order, with the drives between them.
void addInOrder(std::span<const PhotoPose> poses, std::span<const PlanTarget> targets, const CostMap& collision,
                VisitOrder wanted, VisitPlan& plan, Progress& progress) {
    std::vector<Eigen::Vector2d> places_map{{plan.start_map.x_m, plan.start_map.y_m}};
    for (const PhotoPose& pose : poses)
        places_map.emplace_back(pose.pose_map.x_m, pose.pose_map.y_m);
    const VisitLegs legs(collision, places_map, progress);
    progress.report("ordering the visits", 0.0);
    const std::vector<std::size_t> nearest = nearestNextOrder(legs.lengths_m());
    const std::vector<std::size_t> shortest = shortestOrder(legs.lengths_m());
    plan.nearestNextLength_m = lengthOf(nearest, legs.lengths_m());
    plan.shortestTourLength_m = lengthOf(shortest, legs.lengths_m());
    std::size_t here = 0;
    for (const std::size_t next : wanted == VisitOrder::NearestNext ? nearest : shortest) {
        const PhotoPose& pose = poses[next - 1];
        Waypoint waypoint{"", {}, pose.pose_map, pose.cost, WaypointStatus::Ok, legs.drive(here, next)};
        for (const std::size_t target : pose.targets)
            waypoint.candidateIds.push_back(targets[target].candidateId);
        plan.length_m += waypoint.drive.length_m;
        plan.waypoints.push_back(std::move(waypoint));
        here = next;
    }
}

/// Whether the robot gets from its place to where the flood fill says it does: they may have begun at different places.
bool startsOnTheFloodedFloor(const CostMap& collision, const Pose2& robot_map) {
    const auto start = nearestPassableCell(collision, {robot_map.x_m, robot_map.y_m}, kStartTolerance_m);
    return start && collision.isReachable(*start);
}

}  // namespace

std::string toString(WaypointStatus status) {
    switch (status) {
        case WaypointStatus::Ok:
            return "ok";
        case WaypointStatus::Unreachable:
            return "unreachable";
        case WaypointStatus::Hidden:
            return "hidden";
        case WaypointStatus::TooCloseToWall:
            return "too close to a wall";
        case WaypointStatus::OutsideGrid:
            return "outside the grid";
        case WaypointStatus::TooHigh:
            return "too high for the camera";
        case WaypointStatus::TooNear:
            return "too near for the camera";
        case WaypointStatus::TooFar:
            return "too far for the camera";
        case WaypointStatus::LeftOut:
            return "left out by the operator";
    }
    return "unknown";
}

VisitPlan planVisits(std::span<const PlanTarget> targets, const CostMap& collision, const CostMap& sight,
                     const Pose2& robot_map, const WaypointSettings& settings, const CameraSettings& camera,
                     Progress& progress) {
    requireInRange(settings);
    requireSameLattice(collision, sight);
    VisitPlan plan;
    plan.start_map = robot_map;
    progress.throwIfCancelled();
    const SearchFloor floor(collision, sight, targets, settings);
    PhotoPlan photos = planPhotos(targets, floor, CameraFit(camera, settings), settings, progress);
    plan.views = std::move(photos.views);
    if (!startsOnTheFloodedFloor(collision, robot_map)) {
        for (CandidateView& view : plan.views)
            if (view.share > 0.0) view = {view.candidateId, 0.0, WaypointStatus::Unreachable};
        photos.poses.clear();
    }
    addInOrder(photos.poses, targets, collision, settings.order, plan, progress);
    for (const CandidateView& view : plan.views) {
        if (view.share == 0.0) plan.waypoints.push_back({"", {view.candidateId}, std::nullopt, 0.0, view.rest, {}});
    }
    for (std::size_t i = 0; i < plan.waypoints.size(); ++i)
        plan.waypoints[i].id = waypointId(i + 1);
    return plan;
}

}  // namespace fodscope
