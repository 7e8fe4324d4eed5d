// SPDX-License-Identifier: MIT
#include "core/planning/Waypoints.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/common/Error.h"
#include "core/planning/WaypointSearch.h"

namespace fodscope {
namespace {

void requireInRange(const WaypointSettings& settings) {
    const bool ring = settings.minimumDistance_m > 0.0 && settings.minimumDistance_m <= settings.maximumDistance_m &&
                      settings.maximumDistance_m <= 100.0 && settings.closestDistance_m >= 0.0;
    const bool widening = settings.widening >= 0.0 && settings.widening < 1.0 && settings.maximumTries >= 1 &&
                          settings.maximumTries <= 1000;
    const bool steps = settings.angleStep_rad >= 1e-3 && settings.distanceStep_m >= 1e-3 &&
                       settings.rayStep_cells >= 1e-3 && std::isfinite(settings.rayStep_cells) &&
                       std::isfinite(settings.angleStep_rad) && std::isfinite(settings.distanceStep_m);
    const bool threshold = settings.costThresholdPercent > 0.0 && settings.costThresholdPercent <= 99.0;
    if (!ring || !widening || !steps || !threshold) {
        throw Error(
            "waypoint settings", "a value is out of range",
            "give a ring within 100 m whose least distance is not over its greatest, steps of at least 0.001, a "
            "widening from 0 to under 1, 1 to 1000 tries and a cost threshold over 0 up to 99");
    }
}

void requireSameLattice(const CostMap& collision, const CostMap& sight) {
    requireUsable(collision.grid);
    requireUsable(sight.grid);
    const OccupancyGrid& a = collision.grid;
    const OccupancyGrid& b = sight.grid;
    if (a.width != b.width || a.height != b.height || a.resolution_m != b.resolution_m ||
        !(a.origin_map == b.origin_map)) {
        throw Error("sight cost map", "its lattice differs from the collision cost map's",
                    "make both from the same grid");
    }
    if (collision.costs.size() != a.cells.size() || sight.costs.size() != b.cells.size() ||
        collision.reachable.size() != a.cells.size()) {
        throw Error("collision cost map", "it was not inflated and flood filled from the robot's place",
                    "inflate the grid and flood fill it before planning");
    }
}

std::string waypointId(std::size_t number) {
    const std::string digits = std::to_string(number);
    return "W-" + std::string(digits.size() < 2 ? 1 : 0, '0') + digits;
}

/// Moves the reachable waypoints into the plan, each time the one with the shortest way from the last place.
void orderVisits(std::vector<Waypoint>& open, const CostMap& collision, VisitPlan& plan, Progress& progress) {
    Eigen::Vector2d place(plan.start_map.x_m, plan.start_map.y_m);
    const double count = static_cast<double>(open.size());
    while (!open.empty()) {
        progress.report("ordering the visits", 1.0 - static_cast<double>(open.size()) / count);
        const TravelField field(collision, place);
        std::size_t nearest = 0;
        double nearestDistance_m = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < open.size(); ++i) {
            const auto distance_m = field.distanceTo({open[i].pose_map->x_m, open[i].pose_map->y_m});
            if (!distance_m || *distance_m >= nearestDistance_m) continue;
            nearest = i;
            nearestDistance_m = *distance_m;
        }
        if (!std::isfinite(nearestDistance_m)) return;
        Waypoint next = std::move(open[nearest]);
        open.erase(open.begin() + static_cast<std::ptrdiff_t>(nearest));
        place = {next.pose_map->x_m, next.pose_map->y_m};
        next.drive = *field.pathTo(place);
        plan.length_m += next.drive.length_m;
        plan.waypoints.push_back(std::move(next));
    }
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
    }
    return "unknown";
}

VisitPlan planVisits(std::span<const PlanTarget> targets, const CostMap& collision, const CostMap& sight,
                     const Pose2& robot_map, const WaypointSettings& settings, Progress& progress) {
    requireInRange(settings);
    requireSameLattice(collision, sight);
    VisitPlan plan;
    plan.start_map = robot_map;
    std::vector<Waypoint> open;
    std::vector<Waypoint> without;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        progress.report("choosing waypoints", static_cast<double>(i) / static_cast<double>(targets.size()));
        const WaypointChoice choice = chooseWaypoint(targets[i], collision, sight, settings);
        Waypoint waypoint{"", {targets[i].candidateId}, choice.pose_map, choice.cost, choice.status, {}};
        (choice.pose_map ? open : without).push_back(std::move(waypoint));
    }
    orderVisits(open, collision, plan, progress);
    // Left over when the robot's place is not the one that the flood fill began at.
    for (Waypoint& waypoint : open) {
        waypoint.pose_map.reset();
        waypoint.cost = 0.0;
        waypoint.status = WaypointStatus::Unreachable;
        plan.waypoints.push_back(std::move(waypoint));
    }
    std::move(without.begin(), without.end(), std::back_inserter(plan.waypoints));
    for (std::size_t i = 0; i < plan.waypoints.size(); ++i)
        plan.waypoints[i].id = waypointId(i + 1);
    return plan;
}

}  // namespace fodscope
