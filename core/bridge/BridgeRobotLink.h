// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "core/robot/RobotLink.h"

namespace fodscope::bridge {

struct BridgeRobotSettings {
    /// ROS_MASTER_URI; empty: that of the environment, or this computer's.
    std::string masterUri;
    /// How the robot reaches this computer; empty: found out by ROS.
    std::string ownAddress;
    /// See BridgeParameters.h; those that are missing have their usual values.
    std::map<std::string, std::string> parameters;
    /// The bridge; empty: `fodscope-ros1-bridge` beside this program.
    std::filesystem::path program;
    double silentAfter_s = 5.0;
};

/// A robot that speaks ROS 1, behind a bridge process that is started, watched and replaced here. connect() starts it.
/// @throws Error for parameters that are none, or when the bridge is not installed
std::unique_ptr<RobotLink> makeBridgeRobot(const BridgeRobotSettings& settings);

/// Of the bridge process that runs now, for those who look after processes; 0: none, or no such robot.
int bridgeProcessId(const RobotLink& robot);

/// Whether the ROS 1 bridge is installed beside this program.
bool isBridgeInstalled();

}  // namespace fodscope::bridge
