// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>

#include "core/planning/CostMap.h"

namespace fodscope {
namespace {

/// A metre over the dearest passable cell counts as five over free floor, as in navfn (neutral 50, factor 0.8).
double effortPerMetre(std::uint8_t cost) {
    return 1.0 + 4.0 * cost / (kCostInscribed - 1);
}

}  // namespace

TravelField::TravelField(const CostMap& costMap, const Eigen::Vector2d& start_map)
    : costMap_(&costMap),
      start_map_(start_map),
      effort_(costMap.costs.size(), std::numeric_limits<float>::infinity()),
      length_m_(costMap.costs.size(), 0.0F),
      previous_(costMap.costs.size(), -1) {
    const auto start = nearestPassableCell(costMap, start_map, kStartTolerance_m);
    if (start) spreadFrom(*start);
}

bool TravelField::isPassable(CellIndex index) const {
    return costMap_->grid.contains(index) && costMap_->costAt(index) < kCostInscribed;
}

void TravelField::spreadFrom(CellIndex start) {
    struct Step {
        CellIndex move;
        double length_cells;
    };
    constexpr double kDiagonal = std::numbers::sqrt2;
    constexpr std::array<Step, 8> kSteps{{{{1, 0}, 1.0},
                                          {{-1, 0}, 1.0},
                                          {{0, 1}, 1.0},
                                          {{0, -1}, 1.0},
                                          {{1, 1}, kDiagonal},
                                          {{-1, 1}, kDiagonal},
                                          {{1, -1}, kDiagonal},
                                          {{-1, -1}, kDiagonal}}};
    const OccupancyGrid& grid = costMap_->grid;
    using Entry = std::pair<float, std::size_t>;
    // Equal efforts leave in the order of their cells, so that the paths do not depend on the library.
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    effort_[grid.offset(start)] = 0.0F;
    open.emplace(0.0F, grid.offset(start));
    while (!open.empty()) {
        const auto [effort, cell] = open.top();
        open.pop();
        if (effort > effort_[cell]) continue;
        const CellIndex here{static_cast<int>(cell % static_cast<std::size_t>(grid.width)),
                             static_cast<int>(cell / static_cast<std::size_t>(grid.width))};
        for (const auto& [move, length_cells] : kSteps) {
            const CellIndex next{here.column + move.column, here.row + move.row};
            if (!isPassable(next)) continue;
            // No cutting of corners: both cells beside a diagonal step must be passable.
            if (!isPassable({here.column, next.row}) || !isPassable({next.column, here.row})) continue;
            const std::size_t nextCell = grid.offset(next);
            const double length_m = length_cells * grid.resolution_m;
            const double weight =
                0.5 * (effortPerMetre(costMap_->costs[cell]) + effortPerMetre(costMap_->costs[nextCell]));
            const auto nextEffort = static_cast<float>(effort + length_m * weight);
            if (!(nextEffort < effort_[nextCell])) continue;
            effort_[nextCell] = nextEffort;
            length_m_[nextCell] = static_cast<float>(length_m_[cell] + length_m);
            previous_[nextCell] = static_cast<std::int32_t>(cell);
            open.emplace(nextEffort, nextCell);
        }
    }
}

std::optional<double> TravelField::distanceTo(const Eigen::Vector2d& goal_map) const {
    const OccupancyGrid& grid = costMap_->grid;
    const CellIndex goal = grid.cellAt(goal_map);
    if (!grid.contains(goal) || !std::isfinite(effort_[grid.offset(goal)])) return std::nullopt;
    return length_m_[grid.offset(goal)];
}

/// Effort of the straight line, infinite when it leaves the passable cells.
double TravelField::effortAlong(const Eigen::Vector2d& from_map, const Eigen::Vector2d& to_map) const {
    const OccupancyGrid& grid = costMap_->grid;
    const double length_m = (to_map - from_map).norm();
    const int steps = static_cast<int>(std::ceil(length_m / (0.25 * grid.resolution_m))) + 1;
    double effort = 0.0;
    CellIndex last = grid.cellAt(from_map);
    for (int step = 0; step <= steps; ++step) {
        const CellIndex index = grid.cellAt(from_map + (to_map - from_map) * (static_cast<double>(step) / steps));
        // The line may slip over a corner between two samples; both cells beside it must be passable then.
        const bool clear =
            isPassable(index) && isPassable({last.column, index.row}) && isPassable({index.column, last.row});
        if (!clear) return std::numeric_limits<double>::infinity();
        last = index;
        const double share = step == 0 || step == steps ? 0.5 : 1.0;
        effort += share * effortPerMetre(costMap_->costAt(index)) * length_m / steps;
    }
    return effort;
}

/// Leaves out the points between two that see each other at no more effort than over the points between.
std::vector<Eigen::Vector2d> TravelField::straightened(const std::vector<Eigen::Vector2d>& points_map) const {
    constexpr double kSlack = 1.001;
    std::vector<Eigen::Vector2d> kept{points_map.front()};
    std::size_t here = 0;
    while (here + 1 < points_map.size()) {
        std::size_t next = here + 1;
        double stepped = effortAlong(points_map[here], points_map[next]);
        while (next + 1 < points_map.size()) {
            stepped += effortAlong(points_map[next], points_map[next + 1]);
            const double straight = effortAlong(points_map[here], points_map[next + 1]);
            if (!std::isfinite(straight) || straight > kSlack * stepped) break;
            ++next;
        }
        kept.push_back(points_map[next]);
        here = next;
    }
    return kept;
}

std::optional<DrivePath> TravelField::pathTo(const Eigen::Vector2d& goal_map) const {
    const OccupancyGrid& grid = costMap_->grid;
    if (!distanceTo(goal_map)) return std::nullopt;
    std::vector<std::size_t> cells;
    for (auto cell = static_cast<std::int32_t>(grid.offset(grid.cellAt(goal_map))); cell >= 0;
         cell = previous_[static_cast<std::size_t>(cell)]) {
        cells.push_back(static_cast<std::size_t>(cell));
    }
    std::reverse(cells.begin(), cells.end());
    std::vector<Eigen::Vector2d> points_map;
    for (const std::size_t cell : cells) {
        const auto width = static_cast<std::size_t>(grid.width);
        points_map.push_back(grid.centreOf({static_cast<int>(cell % width), static_cast<int>(cell / width)}));
    }
    // The robot stands and stops between the cells' centres.
    if (grid.cellAt(start_map_) == grid.cellAt(points_map.front())) {
        points_map.front() = start_map_;
    } else {
        points_map.insert(points_map.begin(), start_map_);
    }
    if (points_map.size() > 1) {
        points_map.back() = goal_map;
    } else {
        points_map.push_back(goal_map);
    }
    DrivePath path{straightened(points_map), 0.0};
    for (std::size_t i = 1; i < path.points_map.size(); ++i) {
        path.length_m += (path.points_map[i] - path.points_map[i - 1]).norm();
    }
    return path;
}

}  // namespace fodscope
