// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/planning/OccupancyGrid.h"

namespace fodscope {

struct RouteSettings {
    /// Distance between neighbouring places at which the robot stops and looks round.
    double lookSpacing_m = 0.7;
    double keyFrameSpacing_m = 0.08;
    /// Turning on the spot takes a key frame each time this angle is through.
    double keyFrameTurn_rad = 0.6981317007977318;
    /// Moves the lattice of the places, so that no two runs drive alike.
    std::uint64_t seed = 1;
};

/// Poses of the key frames of a closed drive over all floor that the robot reaches: from the start to the nearest place
/// not yet seen, a turn on the spot there, and so on, and back.
/// @throws Error when the start is not on reachable floor
std::vector<Pose2> mappingRoute(const OccupancyGrid& grid, const Pose2& start, const RouteSettings& settings);

}  // namespace fodscope
