// SPDX-License-Identifier: MIT
#include "core/planning/WaypointSearch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fodscope {
namespace {

/// Where the poses of one target's rings fell.
struct Tally {
    int inGrid = 0;
    int onUnknown = 0;
    int nearWall = 0;
    int clear = 0;
    int reachable = 0;
    /// Some clear pose sees the target, but the robot cannot get there.
    bool isSeenFromBeyondReach = false;
};

/// What stopped the poses that came farthest through the tests: the most helpful reason to show.
WaypointStatus reasonFrom(const Tally& tally) {
    if (tally.inGrid == 0) return WaypointStatus::OutsideGrid;
    // The rings widen into the reachable floor even where the target stands in another compartment.
    if (tally.isSeenFromBeyondReach) return WaypointStatus::Unreachable;
    if (tally.reachable > 0) return WaypointStatus::Hidden;
    if (tally.clear > 0 || tally.onUnknown > tally.nearWall) return WaypointStatus::Unreachable;
    return WaypointStatus::TooCloseToWall;
}

enum class Standing { Blocked, BeyondReach, Reachable };

Standing standingAt(const Eigen::Vector2d& place_map, const CostMap& collision, double threshold_percent,
                    Tally& tally) {
    const CellIndex index = collision.grid.cellAt(place_map);
    if (!collision.grid.contains(index)) return Standing::Blocked;
    ++tally.inGrid;
    const std::uint8_t cost = collision.costAt(index);
    if (cost == kCostUnknown) {
        ++tally.onUnknown;
        return Standing::Blocked;
    }
    if (costPercent(cost) >= threshold_percent) {
        ++tally.nearWall;
        return Standing::Blocked;
    }
    ++tally.clear;
    if (!collision.isReachable(index)) return Standing::BeyondReach;
    ++tally.reachable;
    return Standing::Reachable;
}

struct Ring {
    double minimum_m;
    double maximum_m;
};

Ring ringOfTry(int attempt, const PlanTarget& target, const WaypointSettings& settings) {
    const double inwards_m = settings.minimumDistance_m * std::pow(1.0 - settings.widening, attempt);
    const double halfLength_m = 0.5 * std::max({0.0, target.size_m.x(), target.size_m.y()});
    const double closest_m = std::min(settings.closestDistance_m + halfLength_m, settings.minimumDistance_m);
    return {std::max(inwards_m, closest_m), settings.maximumDistance_m * std::pow(1.0 + settings.widening, attempt)};
}

std::optional<WaypointChoice> bestOnRing(const Ring& ring, const PlanTarget& target, const CostMap& collision,
                                         const CostMap& sight, const WaypointSettings& settings, Tally& tally) {
    const Eigen::Vector2d centre = target.centroid_map.head<2>();
    // The slack keeps the last step when the division falls a rounding error short of a whole number.
    const int angles = static_cast<int>(std::ceil(2.0 * std::numbers::pi / settings.angleStep_rad - 1e-6));
    const int distances =
        1 + static_cast<int>(std::floor((ring.maximum_m - ring.minimum_m) / settings.distanceStep_m + 1e-6));
    std::optional<WaypointChoice> best;
    for (int angleStep = 0; angleStep < angles; ++angleStep) {
        const double angle_rad = angleStep * settings.angleStep_rad;
        const Eigen::Vector2d direction(std::cos(angle_rad), std::sin(angle_rad));
        for (int distanceStep = 0; distanceStep < distances; ++distanceStep) {
            const double distance_m = ring.minimum_m + distanceStep * settings.distanceStep_m;
            const Eigen::Vector2d place = centre + distance_m * direction;
            const Standing standing = standingAt(place, collision, settings.costThresholdPercent, tally);
            if (standing == Standing::Blocked) continue;
            if (standing == Standing::BeyondReach && tally.isSeenFromBeyondReach) continue;
            const auto cost = costOfSight(place, target, sight, settings.rayStep_cells);
            if (standing == Standing::BeyondReach) tally.isSeenFromBeyondReach = cost.has_value();
            if (standing == Standing::BeyondReach || !cost || (best && *cost >= best->cost)) continue;
            const double yaw_rad = std::atan2(-direction.y(), -direction.x());
            best = {WaypointStatus::Ok, Pose2{place.x(), place.y(), yaw_rad}, *cost};
        }
    }
    return best;
}

}  // namespace

std::optional<double> costOfSight(const Eigen::Vector2d& place_map, const PlanTarget& target, const CostMap& sight,
                                  double rayStep_cells) {
    const OccupancyGrid& grid = sight.grid;
    const Eigen::Vector2d way = target.centroid_map.head<2>() - place_map;
    const double halfWidth_m = 0.5 * std::max(0.0, std::min(target.size_m.x(), target.size_m.y()));
    // The slack keeps the last step where the length is a whole number of steps but for rounding.
    const double length_m = way.norm() - halfWidth_m - grid.resolution_m + 1e-9;
    const double step_m = rayStep_cells * grid.resolution_m;
    const Eigen::Vector2d direction = way.normalized();
    double cost = 0.0;
    for (int step = 0; step * step_m <= length_m; ++step) {
        const CellIndex index = grid.cellAt(place_map + step * step_m * direction);
        const std::uint8_t here = grid.contains(index) ? sight.costAt(index) : kCostUnknown;
        if (here == kCostLethal) return std::nullopt;
        cost += std::min(here, kCostInscribed);
    }
    return cost;
}

WaypointChoice chooseWaypoint(const PlanTarget& target, const CostMap& collision, const CostMap& sight,
                              const WaypointSettings& settings) {
    if (!target.centroid_map.allFinite()) return {WaypointStatus::OutsideGrid, std::nullopt, 0.0};
    const OccupancyGrid& grid = collision.grid;
    const double farthest_m = std::hypot(grid.width, grid.height) * grid.resolution_m + settings.maximumDistance_m;
    Tally tally;
    for (int attempt = 0; attempt < settings.maximumTries; ++attempt) {
        const Ring ring = ringOfTry(attempt, target, settings);
        if (ring.maximum_m > farthest_m) break;
        const auto best = bestOnRing(ring, target, collision, sight, settings, tally);
        if (best) return *best;
    }
    return {reasonFrom(tally), std::nullopt, 0.0};
}

}  // namespace fodscope
