// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "core/planning/CostMap.h"
#include "core/robot/RobotLink.h"
#include "core/simulation/DepthMapping.h"
#include "core/simulation/PhotoCamera.h"
#include "core/simulation/World.h"

namespace fodscope {

struct SimulatedRobotSettings {
    double speed_m_per_s = 0.22;
    double turnSpeed_rad_per_s = 1.0;
    double acknowledgeDelay_s = 0.2;
    double photoDelay_s = 0.4;
    PhotoCameraSettings camera;
    /// It maps while it drives, and requestMap() is answered with what it has seen until then.
    std::optional<DepthMappingSettings> mapping;
    /// Photos are rendered in a thread of their own. With a clock faster than real time a photo would be late for no
    /// fault of the robot: then poll() waits for the one that is due.
    bool waitForRendering = false;
    /// Ends that wait, and the photo comes with a later poll(); asked some fifty times a second. Empty: never.
    std::function<bool()> isWaitOver;
};

/// The usual robot with this camera.
inline SimulatedRobotSettings robotWith(const CameraSettings& camera) {
    SimulatedRobotSettings settings;
    settings.camera = PhotoCameraSettings{camera};
    return settings;
}

/// A robot that behaves: it confirms goals, drives the cost map's paths at a robot's speed and takes photos of the
/// world. Map and grid are answered when they were given to it, or the map when it has made one itself.
/// It starts where the world says, and takes photos while it stands. Connect it first.
/// @param grid_map the robot's own grid in the map frame
/// @param map what requestMap() answers; may be empty
/// @throws Error for a grid without cells or one that does not cover the robot's start, and settings out of range
std::unique_ptr<RobotLink> makeSimulatedRobot(std::shared_ptr<const World> world, OccupancyGrid grid_map,
                                              std::shared_ptr<const PointCloud> map, const CostMapSettings& costMap,
                                              const SimulatedRobotSettings& settings);

}  // namespace fodscope
