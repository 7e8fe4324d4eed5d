// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "core/planning/CostMap.h"
#include "core/robot/RobotLink.h"
#include "core/simulation/PhotoCamera.h"
#include "core/simulation/World.h"

namespace fodscope {

struct SimulatedRobotSettings {
    double speed_m_per_s = 0.22;
    double turnSpeed_rad_per_s = 1.0;
    double acknowledgeDelay_s = 0.2;
    double photoDelay_s = 0.4;
    PhotoCameraSettings camera;
};

/// A robot that behaves: it confirms goals, drives the cost map's paths at a robot's speed and takes photos of the
/// world. Map and grid are answered when they were given to it.
/// @param grid_map the robot's own grid in the map frame
std::unique_ptr<RobotLink> makeSimulatedRobot(std::shared_ptr<const World> world, OccupancyGrid grid_map,
                                              std::shared_ptr<const PointCloud> map, const CostMapSettings& costMap,
                                              const SimulatedRobotSettings& settings);

}  // namespace fodscope
