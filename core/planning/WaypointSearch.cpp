// SPDX-License-Identifier: MIT
#include "core/planning/WaypointSearch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/planning/DistanceTransform.h"

namespace fodscope {
namespace {

/// Where the places on one part's rings fell.
struct Tally {
    int inGrid = 0;
    int onUnknown = 0;
    int tooNear = 0;
    int clear = 0;
    int reachable = 0;
    /// Of the reachable ones with a free line of sight.
    int tooHigh = 0;
    int tooClose = 0;
    int tooFar = 0;
    /// Some clear place sees the part, but the robot cannot get there.
    bool isSeenFromBeyondReach = false;

    void count(Standing standing) {
        if (standing == Standing::OutsideGrid) return;
        ++inGrid;
        if (standing == Standing::OnUnknown) ++onUnknown;
        if (standing == Standing::TooNear) ++tooNear;
        if (standing == Standing::BeyondReach || standing == Standing::Reachable) ++clear;
        if (standing == Standing::Reachable) ++reachable;
    }

    void count(PictureFit fit) {
        if (fit == PictureFit::TooHigh) ++tooHigh;
        if (fit == PictureFit::TooNear) ++tooClose;
        if (fit == PictureFit::TooFar) ++tooFar;
    }
};

/// What stopped the places that came farthest through the tests: the most helpful reason to show.
WaypointStatus reasonFrom(const Tally& tally) {
    if (tally.inGrid == 0) return WaypointStatus::OutsideGrid;
    // The rings widen into the reachable floor even where the part stands in another compartment.
    if (tally.isSeenFromBeyondReach) return WaypointStatus::Unreachable;
    if (tally.tooHigh > 0) return WaypointStatus::TooHigh;
    if (tally.tooClose > 0) return WaypointStatus::TooNear;
    if (tally.tooFar > 0) return WaypointStatus::TooFar;
    if (tally.reachable > 0) return WaypointStatus::Hidden;
    if (tally.clear > 0 || tally.onUnknown > tally.tooNear) return WaypointStatus::Unreachable;
    return WaypointStatus::TooCloseToWall;
}

struct Ring {
    double minimum_m;
    double maximum_m;
};

Ring ringOfTry(int attempt, const WaypointSettings& settings) {
    const double inwards_m = settings.minimumDistance_m * std::pow(1.0 - settings.widening, attempt);
    const double closest_m = std::min(settings.closestDistance_m, settings.minimumDistance_m);
    return {std::max(inwards_m, closest_m), settings.maximumDistance_m * std::pow(1.0 + settings.widening, attempt)};
}

std::vector<PhotoPlace> placesOnRing(const Ring& ring, const PhotoPart& part, const SearchFloor& floor,
                                     const CameraFit& camera, const WaypointSettings& settings, Tally& tally) {
    // The slack keeps the last step when the division falls a rounding error short of a whole number.
    const int angles = static_cast<int>(std::ceil(2.0 * std::numbers::pi / settings.angleStep_rad - 1e-6));
    const int distances =
        1 + static_cast<int>(std::floor((ring.maximum_m - ring.minimum_m) / settings.distanceStep_m + 1e-6));
    std::vector<PhotoPlace> places;
    for (int angleStep = 0; angleStep < angles; ++angleStep) {
        const double angle_rad = angleStep * settings.angleStep_rad;
        const Eigen::Vector2d direction(std::cos(angle_rad), std::sin(angle_rad));
        for (int distanceStep = 0; distanceStep < distances; ++distanceStep) {
            const double distance_m = ring.minimum_m + distanceStep * settings.distanceStep_m;
            PhotoPlace place;
            place.place_map = placeBeside(part, direction, distance_m);
            const Standing standing = floor.standingAt(place.place_map);
            tally.count(standing);
            const bool isClear = standing == Standing::Reachable || standing == Standing::BeyondReach;
            if (!isClear || (standing == Standing::BeyondReach && tally.isSeenFromBeyondReach)) continue;
            const auto cost = floor.costOfSight(place.place_map, part);
            if (!cost) continue;
            const PictureFit fit = camera.fit(place.place_map, part, place.yaws);
            if (standing == Standing::BeyondReach) {
                tally.isSeenFromBeyondReach = fit == PictureFit::Fits;
                continue;
            }
            tally.count(fit);
            if (fit != PictureFit::Fits) continue;
            place.cost = *cost;
            places.push_back(place);
        }
    }
    return places;
}

}  // namespace

SearchFloor::SearchFloor(const CostMap& collision, const CostMap& sight, std::span<const PlanTarget> targets,
                         const WaypointSettings& settings)
    : collision_(&collision),
      sight_(&sight),
      costThresholdPercent_(settings.costThresholdPercent),
      rayStep_cells_(settings.rayStep_cells) {
    const OccupancyGrid& grid = collision.grid;
    std::vector<std::uint8_t> isCandidate(grid.cells.size(), 0);
    for (const PlanTarget& target : targets) {
        for (const Eigen::Vector3d& voxel : target.voxels) {
            const CellIndex index = grid.cellAt(voxel.head<2>());
            if (grid.contains(index)) isCandidate[grid.offset(index)] = 1;
        }
    }
    const double clearance_cells = settings.candidateClearance_m / grid.resolution_m;
    const int limit_cells = static_cast<int>(std::min(std::ceil(clearance_cells), 30'000.0));
    const auto distances = squaredCellDistances(isCandidate, grid.width, grid.height, limit_cells);
    isNearCandidate_.resize(distances.size());
    std::transform(distances.begin(), distances.end(), isNearCandidate_.begin(), [&](std::int32_t distance2) {
        return static_cast<std::uint8_t>(distance2 != kNoSourceNear && distance2 < clearance_cells * clearance_cells);
    });
}

Standing SearchFloor::standingAt(const Eigen::Vector2d& place_map) const {
    const CellIndex index = collision_->grid.cellAt(place_map);
    if (!collision_->grid.contains(index)) return Standing::OutsideGrid;
    const std::uint8_t cost = collision_->costAt(index);
    if (cost == kCostUnknown) return Standing::OnUnknown;
    if (costPercent(cost) >= costThresholdPercent_) return Standing::TooNear;
    if (isNearCandidate_[collision_->grid.offset(index)] != 0) return Standing::TooNear;
    return collision_->isReachable(index) ? Standing::Reachable : Standing::BeyondReach;
}

std::optional<double> SearchFloor::costOfSight(const Eigen::Vector2d& place_map, const PhotoPart& part) const {
    const OccupancyGrid& grid = sight_->grid;
    const Eigen::Vector2d way = part.centre_map - place_map;
    // The slack keeps the last step where the length is a whole number of steps but for rounding.
    const double length_m = way.norm() - 0.5 * part.width_m - grid.resolution_m + 1e-9;
    const double step_m = rayStep_cells_ * grid.resolution_m;
    const Eigen::Vector2d direction = way.normalized();
    double cost = 0.0;
    for (int step = 0; step * step_m <= length_m; ++step) {
        const CellIndex index = grid.cellAt(place_map + step * step_m * direction);
        const std::uint8_t here = grid.contains(index) ? sight_->costAt(index) : kCostUnknown;
        if (here == kCostLethal) return std::nullopt;
        cost += std::min(here, kCostInscribed);
    }
    return cost;
}

double SearchFloor::diagonal_m() const {
    return std::hypot(collision_->grid.width, collision_->grid.height) * collision_->grid.resolution_m;
}

PhotoPlaces placesFor(const PhotoPart& part, const SearchFloor& floor, const CameraFit& camera,
                      const WaypointSettings& settings) {
    const double farthest_m = floor.diagonal_m() + settings.maximumDistance_m;
    Tally tally;
    for (int attempt = 0; attempt < settings.maximumTries; ++attempt) {
        const Ring ring = ringOfTry(attempt, settings);
        if (ring.maximum_m > farthest_m) break;
        std::vector<PhotoPlace> places = placesOnRing(ring, part, floor, camera, settings, tally);
        if (!places.empty()) return {WaypointStatus::Ok, std::move(places)};
    }
    return {reasonFrom(tally), {}};
}

}  // namespace fodscope
