// SPDX-License-Identifier: MIT
#include "core/simulation/DriveMotion.h"

#include <algorithm>
#include <cmath>

namespace fodscope {

DriveMotion::DriveMotion(const Pose2& start_map, const DrivePath& path, const Pose2& goal_map, double speed_m_per_s,
                         double turnSpeed_rad_per_s)
    : goal_map_(goal_map), last_map_(start_map) {
    for (const Eigen::Vector2d& point : path.points_map) {
        const Eigen::Vector2d way = point - Eigen::Vector2d(last_map_.x_m, last_map_.y_m);
        if (way.norm() < 1e-6) continue;
        turnTo(std::atan2(way.y(), way.x()), turnSpeed_rad_per_s);
        driveTo(point, speed_m_per_s);
    }
    turnTo(goal_map.yaw_rad, turnSpeed_rad_per_s);
}

void DriveMotion::turnTo(double yaw_rad, double turnSpeed_rad_per_s) {
    Leg leg{last_map_, last_map_, wrapAngle(yaw_rad - last_map_.yaw_rad), duration_s_, 0.0};
    leg.to_map.yaw_rad = yaw_rad;
    leg.duration_s = std::abs(leg.turn_rad) / turnSpeed_rad_per_s;
    duration_s_ += leg.duration_s;
    last_map_ = leg.to_map;
    legs_.push_back(leg);
}

void DriveMotion::driveTo(const Eigen::Vector2d& point_map, double speed_m_per_s) {
    Leg leg{last_map_, {point_map.x(), point_map.y(), last_map_.yaw_rad}, 0.0, duration_s_, 0.0};
    leg.duration_s = std::hypot(leg.to_map.x_m - leg.from_map.x_m, leg.to_map.y_m - leg.from_map.y_m) / speed_m_per_s;
    duration_s_ += leg.duration_s;
    last_map_ = leg.to_map;
    legs_.push_back(leg);
}

Pose2 DriveMotion::poseAt(double time_s) const {
    if (time_s >= duration_s_) return goal_map_;
    const auto leg = std::find_if(legs_.begin(), legs_.end(),
                                  [&](const Leg& each) { return time_s < each.begin_s + each.duration_s; });
    if (leg == legs_.end()) return goal_map_;
    const double share = std::max(0.0, time_s - leg->begin_s) / leg->duration_s;
    return {leg->from_map.x_m + share * (leg->to_map.x_m - leg->from_map.x_m),
            leg->from_map.y_m + share * (leg->to_map.y_m - leg->from_map.y_m),
            wrapAngle(leg->from_map.yaw_rad + share * leg->turn_rad)};
}

double DriveMotion::distanceLeftAt(double time_s) const {
    double left_m = 0.0;
    for (const Leg& leg : legs_) {
        if (leg.duration_s <= 0.0) continue;
        const double length_m = std::hypot(leg.to_map.x_m - leg.from_map.x_m, leg.to_map.y_m - leg.from_map.y_m);
        left_m += length_m * (1.0 - std::clamp((time_s - leg.begin_s) / leg.duration_s, 0.0, 1.0));
    }
    return left_m;
}

}  // namespace fodscope
