// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "app/ros1_bridge/RosPort.h"

namespace fodscope::bridge {

/// Where the robot is, how old that is, whether the map moved under it, and how its clock goes.
class RobotWatch {
  public:
    RobotWatch(const RosPort& port, const ParameterValues& parameters) : port_(port), parameters_(parameters) {}

    /// Looks the pose up. @return a sentence when the map has jumped, else empty
    std::string look(double now_s);
    /// Compares the robot's clock with this computer's.
    /// @return a sentence when they turn out to differ, else empty
    std::string onStamp(std::int64_t stamp_ns, std::int64_t now_ns, double now_s);

    const std::optional<PlanarPose>& pose_map() const { return pose_map_; }
    double poseAge_s(double now_s) const { return now_s - poseMeasured_s_; }
    std::optional<double> clockAhead_s() const { return clockAhead_s_; }

  private:
    const RosPort& port_;
    const ParameterValues& parameters_;
    std::optional<PlanarPose> pose_map_;
    std::optional<std::int64_t> poseStamp_ns_;
    double poseMeasured_s_ = 0.0;
    std::optional<PlanarPose> map_from_odom_;
    std::optional<double> clockAhead_s_;
    double clockWindow_s_ = 0.0;
    std::optional<double> windowAhead_s_;
    bool hasToldClock_ = false;
};

}  // namespace fodscope::bridge
