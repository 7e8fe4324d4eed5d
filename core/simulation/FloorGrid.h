// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/planning/OccupancyGrid.h"
#include "core/simulation/Raycaster.h"
#include "core/simulation/World.h"

namespace fodscope {

struct FloorGridSettings {
    double resolution_m = 0.05;
    /// Whatever is higher than this over the floor stops the robot; lower things it crosses.
    double obstacleMinimumHeight_m = 0.13;
    double obstacleMaximumHeight_m = 0.45;
};

/// The true occupancy of a world, by casting rays down and across: occupied where something stands between the two
/// heights, free where there is floor under it, else unknown.
/// @param T_frame_from_world the frame (floor near z = 0) that the grid's axes follow
/// @throws Error when the world is too wide for such a grid, or has no surface
OccupancyGrid floorGrid(const World& world, const Raycaster& raycaster, const Transform& T_frame_from_world,
                        const FloorGridSettings& settings);

/// @return 1 for the free cells that connect with the one nearest to `start` (at most 0.3 m away)
std::vector<std::uint8_t> connectedFloor(const OccupancyGrid& grid, const Pose2& start);

/// The grid as a robot that explored it from `start` knows it: what does not border on floor it can get to is unknown.
OccupancyGrid explored(OccupancyGrid grid, const Pose2& start);

/// @return the floor of a world in its map frame, as its robot would know it after exploring it from its start
OccupancyGrid exploredFloor(const World& world);

}  // namespace fodscope
