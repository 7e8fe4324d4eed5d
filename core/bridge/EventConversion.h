// SPDX-License-Identifier: MIT
#pragma once

#include "core/bridge/BridgeProtocol.h"
#include "core/robot/RobotLink.h"

namespace fodscope::bridge {

/// From the bridge's words to those of core. What cannot be is refused: bytes that do not make whole points, grids that
/// are not filled, transforms that are none.
/// @throws Error
std::shared_ptr<const PointCloud> pointCloudOf(const MapCloud& map);
OccupancyGrid occupancyGridOf(const Grid& grid);
fodscope::Photo photoOf(PhotoTaken photo);
RobotState robotStateOf(const State& state, double measuredAgo_s, double now_s);
GoalFailure failureOf(GoalProblem problem);
PhotoFailure failureOf(PhotoProblem problem);

}  // namespace fodscope::bridge
