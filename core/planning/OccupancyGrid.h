// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "core/common/Geometry.h"

namespace fodscope {

enum class Cell : std::uint8_t { Free, Occupied, Unknown };

struct CellIndex {
    int column = 0;
    int row = 0;

    bool operator==(const CellIndex&) const = default;
};

/// A 2D occupancy grid in the map frame, laid out as nav_msgs/OccupancyGrid: row 0 at the origin, x along columns.
struct OccupancyGrid {
    int width = 0;
    int height = 0;
    double resolution_m = 0.05;
    /// Pose of the lower left corner of cell (0, 0) in the map frame.
    Pose2 origin_map;
    /// Row-major, width × height.
    std::vector<Cell> cells;

    bool contains(CellIndex index) const {
        return index.column >= 0 && index.row >= 0 && index.column < width && index.row < height;
    }
    std::size_t offset(CellIndex index) const {
        return static_cast<std::size_t>(index.row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(index.column);
    }
    Cell at(CellIndex index) const { return cells[offset(index)]; }
    /// @return the cell under a point, which may lie outside the grid; NaN lies outside
    CellIndex cellAt(const Eigen::Vector2d& point_map) const;
    Eigen::Vector2d centreOf(CellIndex index) const;
};

/// Grids with more cells than this are refused: no tank has them (250 × 250 m at 5 cm), a broken header does, and
/// planning takes some 20 bytes a cell.
inline constexpr double kGreatestCellCount = 25e6;

/// @throws Error for a grid without cells, whose cells do not fill it, or whose resolution or origin is no number
void requireUsable(const OccupancyGrid& grid);

struct OccupancySettings {
    double resolution_m = 0.05;
    /// Points between these heights over the reference's floor are obstacles. The paper's map has 0.05 to 1 m; the
    /// simulated robot drives over low hoses and stiffeners, hence 0.13 to 0.45 m.
    double obstacleMinimumHeight_m = 0.13;
    double obstacleMaximumHeight_m = 0.45;
    /// Points lower than the obstacle band are floor and make their cell free.
    /// Fewer obstacle points than this in a cell are noise and do not block it.
    int minimumObstaclePoints = 2;
    /// Unknown cells within this distance of known floor, enclosed by it, count as free.
    double closeGaps_m = 0.15;

    bool operator==(const OccupancySettings&) const = default;
};

/// Grid of an aligned map. The heights are taken in the reference frame, the cells in the map frame.
/// @throws Error when there are no points or the grid would have more than 25 million cells
OccupancyGrid occupancyFromMap(std::span<const Eigen::Vector3d> points_map, const Transform& T_reference_from_map,
                               double floorHeight_m, const OccupancySettings& settings);

/// The grid with the cells under points above the threshold, grown by one cell, made free: what lines of sight use
/// ("FOD-less cost map").
OccupancyGrid withoutCandidates(const OccupancyGrid& grid, std::span<const Eigen::Vector3d> discrepantPoints_map);

/// Reads a ROS map_server pair: YAML (image, resolution, origin, negate, occupied_thresh, free_thresh, mode) and
/// PGM/PNG, as map_server's image_loader does: trinary and scale by the thresholds over the pixel's darkness, raw by
/// the pixel as an occupancy in percent. What is neither over the one nor under the other threshold is unknown.
/// @throws Error for a missing key or image, sizes over 25 million cells, or numbers out of range
OccupancyGrid readMapServerGrid(const std::filesystem::path& yamlFile);

/// Writes NAME.yaml and NAME.pgm (254 free, 0 occupied, 205 unknown).
void writeMapServerGrid(const std::filesystem::path& yamlFile, const OccupancyGrid& grid);

}  // namespace fodscope
