// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/ros1_bridge/RosMessages.h"
#include "core/bridge/BridgeParameters.h"
#include "core/bridge/BridgeProtocol.h"

namespace fodscope::bridge {

/// Whoever wants to hear what the robot says. Called from RosPort::spin() alone.
class RosListener {
  public:
    virtual ~RosListener() = default;
    virtual void onCloud(const CloudMessage& message) = 0;
    virtual void onGrid(const GridMessage& message, bool isCostMap) = 0;
    virtual void onGridUpdate(const GridUpdateMessage& message, bool isCostMap) = 0;
    virtual void onPath(const PathMessage& message) = 0;
    virtual void onImage(const ImageMessage& message) = 0;
    virtual void onCameraInfo(const CameraInfoMessage& message) = 0;
    virtual void onOdometry(const OdometryMessage& message) = 0;
    virtual void onTransforms() = 0;
    virtual void onGoalStatus(const std::vector<GoalStatusMessage>& goals) = 0;
    virtual void onGoalFeedback(const std::string& id) = 0;
    virtual void onGoalResult(const GoalStatusMessage& result) = 0;
    virtual void onServiceAnswered(const ServiceAnswered& answer) = 0;
};

struct StampedTransform {
    Rows T_target_from_source{};
    /// Of the oldest part of the chain; 0 when all of it is static.
    std::int64_t stamp_ns = 0;
};

/// What the bridge wants of ROS. Behind it is roscpp; tests put a robot of their own behind it. Nothing blocks.
class RosPort {
  public:
    virtual ~RosPort() = default;
    /// Registers everything with the master; anew, when it was done before.
    virtual void attach(RosListener& listener) = 0;
    /// Hands on what came since the last call.
    virtual void spin() = 0;
    virtual void watchCloud(bool on) = 0;
    virtual void watchImage(bool compressed) = 0;
    /// How many action servers hear goals.
    virtual int goalListeners() const = 0;
    virtual void publishGoal(const GoalStatusMessage& goal, const std::string& frame, const PlanarPose& pose) = 0;
    virtual void publishCancelAll() = 0;
    virtual void publishSpeeds(double forward_m_per_s, double turn_rad_per_s) = 0;
    /// @param stamp_ns missing: the latest that is known
    virtual std::optional<StampedTransform> lookup(const std::string& target, const std::string& source,
                                                   std::optional<std::int64_t> stamp_ns) const = 0;
    /// The answer comes through the listener.
    virtual void callService(const std::string& service) = 0;
    /// This computer's clock, or the simulated one.
    virtual std::int64_t now_ns() const = 0;
};

/// @param parameters outlive the port
std::unique_ptr<RosPort> makeRosPort(const ParameterValues& parameters);

/// Has to be called before anything else of ROS; speaks to nobody.
void initialiseRos(const std::string& masterUri, const std::string& ownAddress);
/// Leaves the master; ends in a second or two, also when the master does not answer.
void shutDownRos();

/// Type and md5 sum of every message and service that the bridge uses.
std::map<std::string, std::string> usedMessageTypes();

}  // namespace fodscope::bridge
