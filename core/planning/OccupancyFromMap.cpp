// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/common/Error.h"
#include "core/planning/DistanceTransform.h"
#include "core/planning/OccupancyGrid.h"

namespace fodscope {
namespace {

void requireInRange(const OccupancySettings& settings) {
    const bool band = settings.obstacleMinimumHeight_m < settings.obstacleMaximumHeight_m;
    const bool lattice = settings.resolution_m > 0.0 && std::isfinite(settings.resolution_m);
    const bool gaps = settings.closeGaps_m >= 0.0 && std::isfinite(settings.closeGaps_m);
    if (!band || !lattice || !gaps || settings.minimumObstaclePoints < 1) {
        throw Error("occupancy settings", "a value is out of range",
                    "give a resolution over 0 m, obstacle heights in ascending order, at least 1 obstacle point and a "
                    "gap of 0 m or more");
    }
}

enum class Layer { Floor, Obstacle, Above };

/// Where a point stands over the reference's floor.
class LayerOf {
  public:
    LayerOf(const Transform& T_reference_from_map, double floorHeight_m, const OccupancySettings& settings)
        : T_reference_from_map_(T_reference_from_map), floorHeight_m_(floorHeight_m), settings_(settings) {}

    Layer operator()(const Eigen::Vector3d& point_map) const {
        const double height_m = (T_reference_from_map_ * point_map).z() - floorHeight_m_;
        if (height_m < settings_.obstacleMinimumHeight_m) return Layer::Floor;
        // The comparison is false for NaN too, which then counts as above: it neither blocks nor frees.
        return height_m <= settings_.obstacleMaximumHeight_m ? Layer::Obstacle : Layer::Above;
    }

  private:
    const Transform& T_reference_from_map_;
    double floorHeight_m_;
    const OccupancySettings& settings_;
};

struct Bounds {
    Eigen::Vector2d lower = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector2d upper = -lower;
    std::size_t points = 0;
};

Bounds boundsBelowRobotHeight(std::span<const Eigen::Vector3d> points_map, const LayerOf& layerOf) {
    Bounds bounds;
    for (const Eigen::Vector3d& point : points_map) {
        if (!point.allFinite() || layerOf(point) == Layer::Above) continue;
        bounds.lower = bounds.lower.cwiseMin(point.head<2>());
        bounds.upper = bounds.upper.cwiseMax(point.head<2>());
        ++bounds.points;
    }
    return bounds;
}

/// An unknown grid over the bounds, on a lattice whose lines are multiples of the resolution, with room on every side
/// for gaps to be closed without touching the border.
OccupancyGrid unknownGridOver(const Bounds& bounds, const OccupancySettings& settings) {
    const double resolution_m = settings.resolution_m;
    const double margin = 1.0 + std::ceil(settings.closeGaps_m / resolution_m);
    const double firstColumn = std::floor(bounds.lower.x() / resolution_m) - margin;
    const double firstRow = std::floor(bounds.lower.y() / resolution_m) - margin;
    const double columns = std::floor(bounds.upper.x() / resolution_m) + margin - firstColumn + 1.0;
    const double rows = std::floor(bounds.upper.y() / resolution_m) + margin - firstRow + 1.0;
    if (!(columns * rows <= kGreatestCellCount)) {
        throw Error("occupancy grid",
                    "the map would need more than 25 million cells at " + std::to_string(resolution_m) + " m",
                    "check that the map is in metres, or take a coarser resolution");
    }
    OccupancyGrid grid;
    grid.width = static_cast<int>(columns);
    grid.height = static_cast<int>(rows);
    grid.resolution_m = resolution_m;
    grid.origin_map = {firstColumn * resolution_m, firstRow * resolution_m, 0.0};
    grid.cells.assign(static_cast<std::size_t>(columns * rows), Cell::Unknown);
    return grid;
}

/// Closing of the free cells by a disc: what lies in a narrow gap between known floor becomes free.
void closeGaps(OccupancyGrid& grid, double radius_m) {
    const double radius_cells = radius_m / grid.resolution_m;
    const int limit_cells = static_cast<int>(std::ceil(radius_cells));
    if (limit_cells == 0) return;
    std::vector<std::uint8_t> mask(grid.cells.size());
    std::transform(grid.cells.begin(), grid.cells.end(), mask.begin(),
                   [](Cell cell) { return static_cast<std::uint8_t>(cell == Cell::Free); });
    const auto isNear = [&](std::int32_t distance2) {
        return distance2 != kNoSourceNear && distance2 <= radius_cells * radius_cells + 1e-9;
    };
    const auto toFloor = squaredCellDistances(mask, grid.width, grid.height, limit_cells);
    std::transform(toFloor.begin(), toFloor.end(), mask.begin(),
                   [&](std::int32_t distance2) { return static_cast<std::uint8_t>(!isNear(distance2)); });
    const auto toFarCells = squaredCellDistances(mask, grid.width, grid.height, limit_cells);
    for (std::size_t cell = 0; cell < grid.cells.size(); ++cell) {
        if (grid.cells[cell] == Cell::Unknown && !isNear(toFarCells[cell])) grid.cells[cell] = Cell::Free;
    }
}

}  // namespace

OccupancyGrid occupancyFromMap(std::span<const Eigen::Vector3d> points_map, const Transform& T_reference_from_map,
                               double floorHeight_m, const OccupancySettings& settings) {
    requireInRange(settings);
    const LayerOf layerOf(T_reference_from_map, floorHeight_m, settings);
    const Bounds bounds = boundsBelowRobotHeight(points_map, layerOf);
    if (bounds.points == 0) {
        throw Error("occupancy grid",
                    points_map.empty() ? "the map has no points" : "the map has no points at the robot's height",
                    "check that the map shows the floor and is aligned with the reference");
    }
    OccupancyGrid grid = unknownGridOver(bounds, settings);
    std::vector<std::uint16_t> obstaclePoints(grid.cells.size(), 0);
    for (const Eigen::Vector3d& point : points_map) {
        if (!point.allFinite()) continue;
        const Layer layer = layerOf(point);
        if (layer == Layer::Above) continue;
        const CellIndex index = grid.cellAt(point.head<2>());
        if (!grid.contains(index)) continue;
        const std::size_t cell = grid.offset(index);
        if (layer == Layer::Floor) {
            grid.cells[cell] = Cell::Free;
        } else if (obstaclePoints[cell] < std::numeric_limits<std::uint16_t>::max()) {
            ++obstaclePoints[cell];
        }
    }
    for (std::size_t cell = 0; cell < grid.cells.size(); ++cell) {
        if (obstaclePoints[cell] >= settings.minimumObstaclePoints) grid.cells[cell] = Cell::Occupied;
    }
    closeGaps(grid, settings.closeGaps_m);
    return grid;
}

}  // namespace fodscope
