// SPDX-License-Identifier: MIT
#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "app/robot_simulator/RobotModel.h"

namespace fodscope::robot_simulator {

/// @return `settings` with what the node's private parameters say instead
/// @throws std::runtime_error with one sentence for a parameter that is unknown or of another kind
ModelSettings withParameters(ModelSettings settings, const ros::NodeHandle& privateNode);

/// @return the same settings as arguments _NAME:=VALUE of a node
std::vector<std::string> parameterArguments(const ModelSettings& settings);

}  // namespace fodscope::robot_simulator
