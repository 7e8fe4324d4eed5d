// SPDX-License-Identifier: MIT
#include "app/robot_simulator/RobotBody.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/common/Error.h"

namespace fodscope::robot_simulator {
namespace {

/// What the motors of a TurtleBot3 Waffle Pi can do; more is cut off.
constexpr Velocity kMost{0.26, 1.82};

void requireInRange(const ModelSettings& settings) {
    const auto isPositive = [](double value) { return std::isfinite(value) && value > 0.0; };
    if (!isPositive(settings.speed_m_per_s) || !isPositive(settings.turnSpeed_rad_per_s) ||
        !isPositive(settings.commandTimeout_s))
        throw Error("robot simulator", "a speed or the command timeout is not a positive number",
                    "give metres, radians and seconds over 0");
}

double within(double value, double most) {
    return std::isfinite(value) ? std::clamp(value, -most, most) : 0.0;
}

bool isZero(const Velocity& velocity) {
    return velocity.forward_m_per_s == 0.0 && velocity.turn_rad_per_s == 0.0;
}

Velocity velocityBetween(const Pose2& from, const Pose2& to, double seconds) {
    if (!(seconds > 0.0)) return {};
    const double dx = to.x_m - from.x_m, dy = to.y_m - from.y_m;
    const double forward = dx * std::cos(from.yaw_rad) + dy * std::sin(from.yaw_rad);
    return {forward / seconds, wrapAngle(to.yaw_rad - from.yaw_rad) / seconds};
}

}  // namespace

RobotBody::RobotBody(CostMap floor_map, const Pose2& start_map, const ModelSettings& settings)
    : floor_map_(std::move(floor_map)),
      speed_m_per_s_(settings.speed_m_per_s),
      turnSpeed_rad_per_s_(settings.turnSpeed_rad_per_s),
      commandTimeout_s_(settings.commandTimeout_s),
      pose_map_(start_map) {
    requireInRange(settings);
    floodFill(floor_map_, start_map);
}

void RobotBody::advance(double now_s) {
    const double seconds = begun_ ? std::max(0.0, now_s - now_s_) : 0.0;
    now_s_ = begun_ ? std::max(now_s, now_s_) : now_s;
    if (!begun_) stillSince_s_ = now_s;
    begun_ = true;
    if (!(seconds > 0.0)) return;

    const Pose2 before_map = pose_map_;
    if (drive_) {
        const double driven_s = now_s_ - drive_->begin_s;
        pose_map_ = drive_->motion.poseAt(driven_s);
        if (driven_s >= drive_->motion.duration_s()) drive_.reset();
    } else {
        if (command_ && now_s_ - command_->heard_s > commandTimeout_s_) command_.reset();
        roll(seconds);
    }
    velocity_ = velocityBetween(before_map, pose_map_, seconds);
    if (!isZero(velocity_))
        stillSince_s_.reset();
    else if (!stillSince_s_)
        stillSince_s_ = now_s_;
}

void RobotBody::roll(double seconds) {
    if (!command_) return;
    constexpr double kStep_s = 0.02;
    while (seconds > 0.0) {
        const double step_s = std::min(seconds, kStep_s);
        seconds -= step_s;
        const double forward_m = command_->velocity.forward_m_per_s * step_s;
        Pose2 next_map = pose_map_;
        next_map.yaw_rad = wrapAngle(next_map.yaw_rad + command_->velocity.turn_rad_per_s * step_s);
        const Pose2 turned_map = next_map;
        next_map.x_m += forward_m * std::cos(next_map.yaw_rad);
        next_map.y_m += forward_m * std::sin(next_map.yaw_rad);
        // A round robot can always turn on the spot.
        pose_map_ = isBlocked(next_map) ? turned_map : next_map;
    }
}

/// The way out of a place that is blocked itself stays open.
bool RobotBody::isBlocked(const Pose2& next_map) const {
    const auto costAt = [&](const Pose2& pose) {
        const CellIndex cell = floor_map_.grid.cellAt({pose.x_m, pose.y_m});
        return floor_map_.grid.contains(cell) ? floor_map_.costAt(cell) : kCostUnknown;
    };
    const std::uint8_t next = costAt(next_map);
    return next >= kCostInscribed && next >= costAt(pose_map_);
}

bool RobotBody::driveTo(const Pose2& goal_map) {
    stop();
    const TravelField field(floor_map_, {pose_map_.x_m, pose_map_.y_m});
    const auto path = field.pathTo({goal_map.x_m, goal_map.y_m});
    if (!path) return false;
    drive_ = Drive{DriveMotion(pose_map_, *path, goal_map, speed_m_per_s_, turnSpeed_rad_per_s_), now_s_};
    return true;
}

double RobotBody::drivenShare() const {
    if (!drive_ || !(drive_->motion.duration_s() > 0.0)) return 1.0;
    return std::clamp((now_s_ - drive_->begin_s) / drive_->motion.duration_s(), 0.0, 1.0);
}

void RobotBody::stop() {
    drive_.reset();
    command_.reset();
}

void RobotBody::command(const Velocity& velocity) {
    if (drive_) return;
    command_ = Command{{within(velocity.forward_m_per_s, kMost.forward_m_per_s),
                        within(velocity.turn_rad_per_s, kMost.turn_rad_per_s)},
                       now_s_};
}

}  // namespace fodscope::robot_simulator
