// SPDX-License-Identifier: MIT
#include "core/planning/CostMap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <unordered_map>

#include "core/common/Error.h"
#include "core/planning/DistanceTransform.h"

namespace fodscope {
namespace {

void requireInRange(const CostMapSettings& settings) {
    const auto isLength = [](double value) { return std::isfinite(value) && value >= 0.0; };
    if (!isLength(settings.inscribedRadius_m) || !isLength(settings.inflationRadius_m) ||
        !isLength(settings.costScalingFactor)) {
        throw Error("cost map settings", "a radius or the cost scaling factor is negative or not a number",
                    "give numbers of 0 or more");
    }
}

std::uint8_t costAtDistance(double distance_cells, double resolution_m, const CostMapSettings& settings) {
    if (distance_cells == 0.0) return kCostLethal;
    const double distance_m = distance_cells * resolution_m;
    if (distance_m <= settings.inscribedRadius_m) return kCostInscribed;
    const double share = std::exp(-1.0 * settings.costScalingFactor * (distance_m - settings.inscribedRadius_m));
    return static_cast<std::uint8_t>((kCostInscribed - 1) * share);
}

bool isPassable(std::uint8_t cost) {
    return cost < kCostInscribed;
}

}  // namespace

CostMap inflate(const OccupancyGrid& grid, const CostMapSettings& settings) {
    requireUsable(grid);
    requireInRange(settings);
    std::vector<std::uint8_t> occupied(grid.cells.size());
    std::transform(grid.cells.begin(), grid.cells.end(), occupied.begin(),
                   [](Cell cell) { return static_cast<std::uint8_t>(cell == Cell::Occupied); });
    // costmap_2d cuts off by whole cells; what is farther than the grid is wide cannot be reached anyway.
    const double limit_cells = std::min(std::ceil(settings.inflationRadius_m / grid.resolution_m), 30'000.0);
    const auto distances = squaredCellDistances(occupied, grid.width, grid.height, static_cast<int>(limit_cells));

    CostMap costMap{grid, std::vector<std::uint8_t>(grid.cells.size(), kCostFree), {}};
    std::unordered_map<std::int32_t, std::uint8_t> costOfDistance;
    for (std::size_t cell = 0; cell < grid.cells.size(); ++cell) {
        std::uint8_t cost = kCostFree;
        if (distances[cell] != kNoSourceNear) {
            const auto [known, isNew] = costOfDistance.try_emplace(distances[cell], kCostFree);
            if (isNew) {
                known->second =
                    costAtDistance(std::sqrt(static_cast<double>(distances[cell])), grid.resolution_m, settings);
            }
            cost = known->second;
        }
        const bool staysUnknown = grid.cells[cell] == Cell::Unknown && cost < kCostInscribed;
        costMap.costs[cell] = staysUnknown ? kCostUnknown : cost;
    }
    return costMap;
}

double costPercent(std::uint8_t cost) {
    if (cost == kCostFree) return 0.0;
    if (cost == kCostInscribed) return 99.0;
    if (cost >= kCostLethal) return 100.0;
    return 1.0 + 97 * (cost - 1) / 251;
}

std::optional<CellIndex> nearestPassableCell(const CostMap& costMap, const Eigen::Vector2d& place_map,
                                             double tolerance_m) {
    const OccupancyGrid& grid = costMap.grid;
    const CellIndex own = grid.cellAt(place_map);
    if (!grid.contains(own)) return std::nullopt;
    if (isPassable(costMap.costAt(own))) return own;
    const int reach = static_cast<int>(std::min(std::ceil(tolerance_m / grid.resolution_m), 10'000.0)) + 1;
    std::optional<CellIndex> nearest;
    double nearestDistance_m = tolerance_m;
    for (int row = std::max(0, own.row - reach); row <= std::min(grid.height - 1, own.row + reach); ++row) {
        for (int column = std::max(0, own.column - reach); column <= std::min(grid.width - 1, own.column + reach);
             ++column) {
            const CellIndex index{column, row};
            if (!isPassable(costMap.costAt(index))) continue;
            const double distance_m = (grid.centreOf(index) - place_map).norm();
            if (distance_m > nearestDistance_m || (nearest && distance_m == nearestDistance_m)) continue;
            nearest = index;
            nearestDistance_m = distance_m;
        }
    }
    return nearest;
}

void floodFill(CostMap& costMap, const Pose2& robot_map, double startTolerance_m) {
    requireUsable(costMap.grid);
    const OccupancyGrid& grid = costMap.grid;
    const Eigen::Vector2d robot(robot_map.x_m, robot_map.y_m);
    if (!grid.contains(grid.cellAt(robot))) {
        throw Error("robot's place", "it lies outside the grid",
                    "give the robot's pose in the map frame, in metres, or a grid that covers it");
    }
    const std::optional<CellIndex> seed = nearestPassableCell(costMap, robot, startTolerance_m);
    if (!seed) {
        throw Error("robot's place", "the grid has no passable floor near it",
                    "check the robot's pose and the obstacle heights, or place the robot on free floor");
    }
    costMap.reachable.assign(grid.cells.size(), 0);
    std::vector<CellIndex> open{*seed};
    costMap.reachable[grid.offset(*seed)] = 1;
    while (!open.empty()) {
        const CellIndex here = open.back();
        open.pop_back();
        // Four neighbours: a robot does not pass between two cells that touch by a corner only.
        for (const auto [column, row] : {CellIndex{here.column + 1, here.row}, CellIndex{here.column - 1, here.row},
                                         CellIndex{here.column, here.row + 1}, CellIndex{here.column, here.row - 1}}) {
            const CellIndex next{column, row};
            if (!grid.contains(next) || costMap.isReachable(next) || !isPassable(costMap.costAt(next))) continue;
            costMap.reachable[grid.offset(next)] = 1;
            open.push_back(next);
        }
    }
}

}  // namespace fodscope
