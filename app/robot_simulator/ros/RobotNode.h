// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/robot_simulator/RobotModel.h"

namespace fodscope::robot_simulator {

/// Reads the node's parameters, makes the robot from them and is it until ROS ends the node.
/// Without a master it waits for one.
/// @return with which arguments the program is to be started again, when another master has taken the place of the one
///         that the node registered with: the robot then stands where it stood
/// @param arguments the program's, with ROS's own among them
/// @param settings what holds where no parameter says otherwise
/// @throws std::runtime_error with one sentence for a parameter that is unknown or out of range
std::optional<std::vector<std::string>> runRobotNode(std::vector<std::string> arguments, ModelSettings settings);

}  // namespace fodscope::robot_simulator
