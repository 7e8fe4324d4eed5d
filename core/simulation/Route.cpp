// SPDX-License-Identifier: MIT
#include "core/simulation/Route.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "core/planning/CostMap.h"
#include "core/simulation/Random.h"

namespace fodscope {
namespace {

/// Reachable places about `spacing` apart: of each square of a lattice the cell that is farthest from obstacles.
std::vector<Eigen::Vector2d> lookPlaces(const CostMap& costMap, const RouteSettings& settings) {
    Random random(streamSeed(settings.seed, 5));
    const OccupancyGrid& grid = costMap.grid;
    const int step = std::max(1, static_cast<int>(std::lround(settings.lookSpacing_m / grid.resolution_m)));
    const auto span = static_cast<std::uint64_t>(step);
    const int shiftX = static_cast<int>(random.below(span)), shiftY = static_cast<int>(random.below(span));
    std::vector<Eigen::Vector2d> places;
    for (int top = -shiftY; top < grid.height; top += step) {
        for (int left = -shiftX; left < grid.width; left += step) {
            std::optional<CellIndex> best;
            std::pair<int, int> bestRank;
            for (int row = top; row < top + step; ++row) {
                for (int column = left; column < left + step; ++column) {
                    const CellIndex index{column, row};
                    if (!costMap.isReachable(index)) continue;
                    const int across = 2 * (column - left) - step, along = 2 * (row - top) - step;
                    const std::pair<int, int> rank{costMap.costAt(index), across * across + along * along};
                    if (best && bestRank <= rank) continue;
                    best = index;
                    bestRank = rank;
                }
            }
            if (best) places.push_back(grid.centreOf(*best));
        }
    }
    // Neighbouring squares may have chosen cells side by side.
    std::vector<Eigen::Vector2d> apart;
    for (const Eigen::Vector2d& place : places)
        if (std::none_of(apart.begin(), apart.end(), [&](const Eigen::Vector2d& other) {
                return (place - other).norm() < 0.5 * settings.lookSpacing_m;
            }))
            apart.push_back(place);
    return apart;
}

class RouteBuilder {
  public:
    RouteBuilder(const Pose2& start, const RouteSettings& settings) : settings_(settings) { poses.push_back(start); }

    void turnTo(double yaw_rad) { turnBy(wrapAngle(yaw_rad - poses.back().yaw_rad)); }
    void turnRound() { turnBy(2.0 * std::numbers::pi); }

    void driveAlong(const DrivePath& path) {
        for (std::size_t i = 1; i < path.points_map.size(); ++i)
            driveTo(path.points_map[i]);
    }

    std::vector<Pose2> poses;

  private:
    void turnBy(double angle_rad) {
        const int steps = static_cast<int>(std::ceil(std::abs(angle_rad) / settings_.keyFrameTurn_rad - 1e-9));
        const Pose2 from = poses.back();
        for (int step = 1; step <= steps; ++step)
            poses.push_back({from.x_m, from.y_m, wrapAngle(from.yaw_rad + angle_rad * step / steps)});
    }

    void driveTo(const Eigen::Vector2d& goal) {
        const Eigen::Vector2d from(poses.back().x_m, poses.back().y_m);
        const double length = (goal - from).norm();
        if (length < 1e-6) return;
        const double yaw = std::atan2(goal.y() - from.y(), goal.x() - from.x());
        turnTo(yaw);
        const int steps = std::max(1, static_cast<int>(std::ceil(length / settings_.keyFrameSpacing_m)));
        for (int step = 1; step <= steps; ++step) {
            const Eigen::Vector2d at = from + (goal - from) * step / steps;
            poses.push_back({at.x(), at.y(), yaw});
        }
    }

    RouteSettings settings_;
};

}  // namespace

std::vector<Pose2> mappingRoute(const OccupancyGrid& grid, const Pose2& start, const RouteSettings& settings) {
    CostMap costMap = inflate(grid, {});
    floodFill(costMap, start);
    std::vector<Eigen::Vector2d> left = lookPlaces(costMap, settings);
    RouteBuilder route(start, settings);
    route.turnRound();
    const auto here = [&] { return Eigen::Vector2d(route.poses.back().x_m, route.poses.back().y_m); };
    while (!left.empty()) {
        const TravelField field(costMap, here());
        std::size_t nearest = left.size();
        double shortest_m = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < left.size(); ++i) {
            const double length_m = field.distanceTo(left[i]).value_or(std::numeric_limits<double>::infinity());
            if (!(length_m < shortest_m)) continue;
            shortest_m = length_m;
            nearest = i;
        }
        const std::optional<DrivePath> path = nearest < left.size() ? field.pathTo(left[nearest]) : std::nullopt;
        if (!path) break;
        route.driveAlong(*path);
        route.turnRound();
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(nearest));
    }
    const TravelField field(costMap, here());
    if (const auto home = field.pathTo({start.x_m, start.y_m})) {
        route.driveAlong(*home);
        route.turnTo(start.yaw_rad);
    }
    return route.poses;
}

}  // namespace fodscope
