// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "app/ros1_bridge/RosMessages.h"

namespace fodscope::bridge {

struct StandstillSettings {
    /// Below this speed (m/s), and below as many rad/s, …
    double speed = 0.01;
    /// … for this long the robot stands still.
    double time_s = 0.3;
    /// Odometry older than this says nothing any more.
    double freshFor_s = 1.0;
};

/// Whether the robot stands still, from its odometry alone.
class StandstillWatch {
  public:
    explicit StandstillWatch(StandstillSettings settings) : settings_(settings) {}

    void onOdometry(const OdometryMessage& message, double now_s);

    /// Missing while odometry is silent.
    std::optional<bool> isMoving(double now_s) const;
    /// Since when the robot has stood still, on the robot's clock; missing while it moves, or nobody knows.
    std::optional<std::int64_t> stillSince_ns(double now_s) const;
    /// The same as a length of time.
    std::optional<double> stillFor_s(double now_s) const;

  private:
    StandstillSettings settings_;
    double heard_s_ = 0.0;
    bool hasHeard_ = false;
    /// The first slow message after the last fast one.
    std::optional<std::int64_t> slowSince_ns_;
    double slowSince_s_ = 0.0;
    std::int64_t newest_ns_ = 0;
};

}  // namespace fodscope::bridge
