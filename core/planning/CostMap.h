// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/planning/OccupancyGrid.h"

namespace fodscope {

/// costmap_2d's values.
inline constexpr std::uint8_t kCostFree = 0;
inline constexpr std::uint8_t kCostInscribed = 253;
inline constexpr std::uint8_t kCostLethal = 254;
inline constexpr std::uint8_t kCostUnknown = 255;

/// How far the robot's place may lie from passable floor: it is a little off, or a point lies under the robot.
inline constexpr double kStartTolerance_m = 0.3;

struct CostMapSettings {
    /// costmap_2d's inscribed radius: robot_radius 0.17 m with padding 0.05 m as a 16-gon.
    double inscribedRadius_m = 0.2154;
    double inflationRadius_m = 0.5;
    double costScalingFactor = 10.0;

    bool operator==(const CostMapSettings&) const = default;
};

/// Costs on the lattice of a grid.
struct CostMap {
    OccupancyGrid grid;
    /// One cost a cell, row-major as the grid.
    std::vector<std::uint8_t> costs;
    /// 1 for cells that a flood fill from the robot reaches through cells under the inscribed cost.
    std::vector<std::uint8_t> reachable;

    std::uint8_t costAt(CellIndex index) const { return costs[grid.offset(index)]; }
    bool isReachable(CellIndex index) const { return grid.contains(index) && reachable[grid.offset(index)] != 0; }
};

/// Inflation by costmap_2d's formula over the exact Euclidean distance between cell centres: 254 at an obstacle, 253 up
/// to the inscribed radius, then floor(252·exp(−scaling·(d − inscribed))), 0 past the inflation radius; unknown stays
/// 255 unless the new cost is at least 253. `reachable` is empty until flood filled.
CostMap inflate(const OccupancyGrid& grid, const CostMapSettings& settings);

/// @return the cost as nav_msgs/OccupancyGrid shows it, in percent: 0 free, 1 to 98 inflated, 99 inscribed, 100 lethal.
///         Unknown is as blocked as lethal here.
double costPercent(std::uint8_t cost);

/// @return the cell under the place when it is passable (under the inscribed cost, known), else the nearest passable
///         one whose centre lies within the tolerance; empty outside the grid or when there is none
std::optional<CellIndex> nearestPassableCell(const CostMap& costMap, const Eigen::Vector2d& place_map,
                                             double tolerance_m);

/// Flood fill from the robot's place (paper: "Waypoint Generation"). When the robot's own cell is blocked (its position
/// is a little off, or a point lies under it) the nearest passable cell within `startTolerance_m` is the seed.
/// @throws Error when the robot is outside the grid or no passable cell is near it
void floodFill(CostMap& costMap, const Pose2& robot_map, double startTolerance_m = kStartTolerance_m);

/// A path over passable cells with its length.
struct DrivePath {
    std::vector<Eigen::Vector2d> points_map;
    double length_m = 0.0;
};

/// Travel distances from one place to every reachable cell (Dijkstra over 8 neighbours, cost-weighted so that paths
/// keep off walls), and the paths behind them. The cost map must outlive it.
class TravelField {
  public:
    /// A start on a blocked cell begins at the nearest passable one within kStartTolerance_m; a start with none near it
    /// reaches nothing.
    TravelField(const CostMap& costMap, const Eigen::Vector2d& start_map);

    /// The path is straightened where a straight line is no dearer than the way over the cells' centres.
    /// @return empty when the cell of `goal_map` is not reached
    std::optional<DrivePath> pathTo(const Eigen::Vector2d& goal_map) const;

    /// @return the length over the cells' steps, which is cheaper to ask for than the path; empty when not reached
    std::optional<double> distanceTo(const Eigen::Vector2d& goal_map) const;

  private:
    bool isPassable(CellIndex index) const;
    void spreadFrom(CellIndex start);
    double effortAlong(const Eigen::Vector2d& from_map, const Eigen::Vector2d& to_map) const;
    std::vector<Eigen::Vector2d> straightened(const std::vector<Eigen::Vector2d>& points_map) const;

    const CostMap* costMap_;
    Eigen::Vector2d start_map_;
    std::vector<float> effort_;
    std::vector<float> length_m_;
    std::vector<std::int32_t> previous_;
};

}  // namespace fodscope
