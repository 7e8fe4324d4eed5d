// SPDX-License-Identifier: MIT
#pragma once

#include <ros/time.h>

#include "app/robot_simulator/ros/Faults.h"

namespace fodscope::robot_simulator {

/// The clock of the robot's computer, which stamps all that it sends.
class RobotClock {
  public:
    explicit RobotClock(const Faults& faults) : faults_(faults) {}

    ros::Time now() const { return at(ros::SteadyTime::now().toSec()); }
    /// @param time_s of the monotonic clock that the simulation runs by
    ros::Time at(double time_s) const {
        const double ago_s = ros::SteadyTime::now().toSec() - time_s;
        return ros::Time::now() + ros::Duration(faults_.clockOffset_s - ago_s);
    }

  private:
    const Faults& faults_;
};

}  // namespace fodscope::robot_simulator
