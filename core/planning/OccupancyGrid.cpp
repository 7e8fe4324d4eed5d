// SPDX-License-Identifier: MIT
#include "core/planning/OccupancyGrid.h"

#include <cmath>
#include <string>

#include "core/common/Error.h"

namespace fodscope {
namespace {

/// @return the index along one axis, −1 for whatever is no index at all (NaN, far outside)
int indexAlong(double coordinate_cells) {
    constexpr double kFarthest = 1e9;
    if (!(std::abs(coordinate_cells) < kFarthest)) return -1;
    return static_cast<int>(std::floor(coordinate_cells));
}

}  // namespace

CellIndex OccupancyGrid::cellAt(const Eigen::Vector2d& point_map) const {
    const double dx_m = point_map.x() - origin_map.x_m;
    const double dy_m = point_map.y() - origin_map.y_m;
    const double cosine = std::cos(origin_map.yaw_rad);
    const double sine = std::sin(origin_map.yaw_rad);
    return {indexAlong((cosine * dx_m + sine * dy_m) / resolution_m),
            indexAlong((-sine * dx_m + cosine * dy_m) / resolution_m)};
}

Eigen::Vector2d OccupancyGrid::centreOf(CellIndex index) const {
    const double u_m = (index.column + 0.5) * resolution_m;
    const double v_m = (index.row + 0.5) * resolution_m;
    const double cosine = std::cos(origin_map.yaw_rad);
    const double sine = std::sin(origin_map.yaw_rad);
    return {origin_map.x_m + cosine * u_m - sine * v_m, origin_map.y_m + sine * u_m + cosine * v_m};
}

void requireUsable(const OccupancyGrid& grid) {
    const bool sized = grid.width > 0 && grid.height > 0;
    if (!sized || grid.cells.empty()) {
        throw Error("occupancy grid", "it has no cells", "give a grid that covers the robot's floor");
    }
    if (static_cast<double>(grid.width) * grid.height != static_cast<double>(grid.cells.size())) {
        throw Error("occupancy grid",
                    "it has " + std::to_string(grid.cells.size()) + " cells, but " + std::to_string(grid.width) +
                        " columns and " + std::to_string(grid.height) + " rows",
                    "give a complete grid");
    }
    const Pose2& origin = grid.origin_map;
    const bool placed = std::isfinite(origin.x_m) && std::isfinite(origin.y_m) && std::isfinite(origin.yaw_rad);
    if (!placed || !(grid.resolution_m > 0.0) || !std::isfinite(grid.resolution_m)) {
        throw Error("occupancy grid", "its resolution or origin is not a usable number",
                    "give a resolution over 0 m and a finite origin");
    }
}

OccupancyGrid withoutCandidates(const OccupancyGrid& grid, std::span<const Eigen::Vector3d> discrepantPoints_map) {
    OccupancyGrid freed = grid;
    for (const Eigen::Vector3d& point_map : discrepantPoints_map) {
        const CellIndex centre = grid.cellAt(point_map.head<2>());
        for (int row = centre.row - 1; row <= centre.row + 1; ++row) {
            for (int column = centre.column - 1; column <= centre.column + 1; ++column) {
                const CellIndex index{column, row};
                if (freed.contains(index)) freed.cells[freed.offset(index)] = Cell::Free;
            }
        }
    }
    return freed;
}

}  // namespace fodscope
