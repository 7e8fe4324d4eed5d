// SPDX-License-Identifier: MIT
#include "app/ros1_bridge/StandstillWatch.h"

namespace fodscope::bridge {

void StandstillWatch::onOdometry(const OdometryMessage& message, double now_s) {
    // A gap may hide a drive, and a stamp that went back is another clock.
    const bool isGap = !hasHeard_ || now_s - heard_s_ > settings_.freshFor_s || message.stamp_ns < newest_ns_;
    if (isGap) slowSince_ns_.reset();
    hasHeard_ = true;
    heard_s_ = now_s;
    newest_ns_ = message.stamp_ns;
    // Negated, so that NaN counts as moving.
    if (!(message.speed_m_per_s < settings_.speed && message.turn_rad_per_s < settings_.speed)) {
        slowSince_ns_.reset();
    } else if (!slowSince_ns_) {
        slowSince_ns_ = message.stamp_ns;
        slowSince_s_ = now_s;
    }
}

std::optional<bool> StandstillWatch::isMoving(double now_s) const {
    if (!hasHeard_ || now_s - heard_s_ > settings_.freshFor_s) return std::nullopt;
    return !stillSince_ns(now_s);
}

std::optional<std::int64_t> StandstillWatch::stillSince_ns(double now_s) const {
    const bool isFresh = hasHeard_ && now_s - heard_s_ <= settings_.freshFor_s;
    if (!isFresh || !slowSince_ns_) return std::nullopt;
    const auto needed_ns = static_cast<std::int64_t>(settings_.time_s * 1e9);
    if (newest_ns_ - *slowSince_ns_ < needed_ns) return std::nullopt;
    return *slowSince_ns_ + needed_ns;
}

std::optional<double> StandstillWatch::stillFor_s(double now_s) const {
    if (!stillSince_ns(now_s)) return std::nullopt;
    return now_s - slowSince_s_;
}

}  // namespace fodscope::bridge
