// SPDX-License-Identifier: MIT
#include "app/ros1_bridge/RobotWatch.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/ros1_bridge/GridKeeper.h"

namespace fodscope::bridge {
namespace {

constexpr double kJump_m = 0.15;
constexpr double kJump_rad = 0.09;
constexpr double kClockWindow_s = 2.0;
constexpr double kClocksDiffer_s = 0.5;

std::string withNumber(const char* format, double value) {
    char text[160];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

}  // namespace

std::string RobotWatch::look(double now_s) {
    const std::string& map = parameters_.text("map_frame");
    const auto robot = port_.lookup(map, parameters_.text("base_frame"), std::nullopt);
    if (!robot) {
        pose_map_.reset();
        poseStamp_ns_.reset();
    } else if (poseStamp_ns_ != robot->stamp_ns) {
        poseStamp_ns_ = robot->stamp_ns;
        poseMeasured_s_ = now_s;
        pose_map_ = planarPartOf(robot->T_target_from_source);
    }
    const auto odom = port_.lookup(map, parameters_.text("odom_frame"), std::nullopt);
    if (!odom) return "";
    const auto before = map_from_odom_;
    map_from_odom_ = planarPartOf(odom->T_target_from_source);
    if (!before) return "";
    const double moved_m = std::hypot(map_from_odom_->x_m - before->x_m, map_from_odom_->y_m - before->y_m);
    const double turned_rad = std::abs(std::remainder(map_from_odom_->yaw_rad - before->yaw_rad, 2 * M_PI));
    if (moved_m < kJump_m && turned_rad < kJump_rad) return "";
    return withNumber(
        "the robot corrected its place in the map by %.2f m at once; where waypoints lie may have changed, "
        "look at the plan before going on",
        moved_m);
}

std::string RobotWatch::onStamp(std::int64_t stamp_ns, std::int64_t now_ns, double now_s) {
    // Messages arrive late, never early: the largest lead of a while is nearest to the clocks' difference.
    const double ahead_s = static_cast<double>(stamp_ns - now_ns) * 1e-9;
    windowAhead_s_ = std::max(windowAhead_s_.value_or(ahead_s), ahead_s);
    if (!clockAhead_s_ || *clockAhead_s_ < *windowAhead_s_) clockAhead_s_ = windowAhead_s_;
    if (now_s - clockWindow_s_ >= kClockWindow_s) {
        clockAhead_s_ = windowAhead_s_;
        windowAhead_s_.reset();
        clockWindow_s_ = now_s;
    }
    if (hasToldClock_ || std::abs(*clockAhead_s_) < kClocksDiffer_s) return "";
    hasToldClock_ = true;
    return withNumber(*clockAhead_s_ > 0 ? "the robot's clock is %.1f s ahead of this computer's"
                                         : "the robot's clock is %.1f s behind this computer's",
                      std::abs(*clockAhead_s_));
}

}  // namespace fodscope::bridge
