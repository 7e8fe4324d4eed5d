// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "app/robot_simulator/RobotModel.h"
#include "core/planning/CostMap.h"
#include "core/simulation/DriveMotion.h"

namespace fodscope::robot_simulator {

/// The robot's wheels on the true floor: drives to a goal, and drives by velocity.
class RobotBody {
  public:
    /// @throws Error when the start is not on passable floor
    RobotBody(CostMap floor_map, const Pose2& start_map, const ModelSettings& settings);

    void advance(double now_s);
    const Pose2& pose_map() const { return pose_map_; }
    /// As wheel encoders measure it since the last advance().
    Velocity velocity() const { return velocity_; }
    /// @return since when neither wheel has turned; empty while they turn
    std::optional<double> stillSince_s() const { return stillSince_s_; }

    bool driveTo(const Pose2& goal_map);
    bool isDriving() const { return drive_.has_value(); }
    double drivenShare() const;
    void stop();
    void command(const Velocity& velocity);

  private:
    struct Drive {
        DriveMotion motion;
        double begin_s;
    };
    struct Command {
        Velocity velocity;
        double heard_s;
    };

    void roll(double seconds);
    bool isBlocked(const Pose2& next_map) const;

    CostMap floor_map_;
    double speed_m_per_s_;
    double turnSpeed_rad_per_s_;
    double commandTimeout_s_;
    double now_s_ = 0.0;
    bool begun_ = false;
    Pose2 pose_map_;
    Velocity velocity_;
    std::optional<double> stillSince_s_ = 0.0;
    std::optional<Drive> drive_;
    std::optional<Command> command_;
};

}  // namespace fodscope::robot_simulator
