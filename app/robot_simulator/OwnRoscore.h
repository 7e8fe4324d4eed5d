// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

namespace fodscope::robot_simulator {

/// A roscore that lives as long as this object, unless a master answers at ROS_MASTER_URI already.
class OwnRoscore {
  public:
    /// @throws std::runtime_error with one sentence when there is no roscore to start, or the address is another
    /// machine's
    OwnRoscore();
    ~OwnRoscore();
    OwnRoscore(const OwnRoscore&) = delete;
    OwnRoscore& operator=(const OwnRoscore&) = delete;

  private:
    pid_t process_ = -1;
};

}  // namespace fodscope::robot_simulator
