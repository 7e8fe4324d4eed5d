// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/planning/OccupancyGrid.h"

namespace fodscope {

/// A grid as drawn, first line at the top (greatest y): '#' occupied, '.' free, anything else unknown.
inline OccupancyGrid pictureGrid(const std::vector<std::string>& lines, double resolution_m = 0.05,
                                 const Pose2& origin_map = {}) {
    OccupancyGrid grid;
    grid.width = static_cast<int>(lines.front().size());
    grid.height = static_cast<int>(lines.size());
    grid.resolution_m = resolution_m;
    grid.origin_map = origin_map;
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
        for (const char mark : *line) {
            grid.cells.push_back(mark == '#' ? Cell::Occupied : mark == '.' ? Cell::Free : Cell::Unknown);
        }
    }
    return grid;
}

/// A free floor of so many cells with an occupied border of one cell.
inline OccupancyGrid walledRoom(int columns, int rows, double resolution_m = 0.05) {
    std::string inside(static_cast<std::size_t>(columns), '.');
    inside.front() = inside.back() = '#';
    std::vector<std::string> lines(static_cast<std::size_t>(rows), inside);
    lines.front() = lines.back() = std::string(static_cast<std::size_t>(columns), '#');
    return pictureGrid(lines, resolution_m);
}

}  // namespace fodscope
