// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/planning/CostMap.h"

namespace fodscope {

/// A drive along a path in time: turn towards the next point, drive to it, and at the end turn to the goal's heading.
class DriveMotion {
  public:
    DriveMotion(const Pose2& start_map, const DrivePath& path, const Pose2& goal_map, double speed_m_per_s,
                double turnSpeed_rad_per_s);

    double duration_s() const { return duration_s_; }
    Pose2 poseAt(double time_s) const;
    double distanceLeftAt(double time_s) const;

  private:
    /// A turn on the spot or a straight drive.
    struct Leg {
        Pose2 from_map;
        Pose2 to_map;
        double turn_rad = 0.0;
        double begin_s = 0.0;
        double duration_s = 0.0;
    };

    void turnTo(double yaw_rad, double turnSpeed_rad_per_s);
    void driveTo(const Eigen::Vector2d& point_map, double speed_m_per_s);

    Pose2 goal_map_;
    Pose2 last_map_;
    std::vector<Leg> legs_;
    double duration_s_ = 0.0;
};

}  // namespace fodscope
