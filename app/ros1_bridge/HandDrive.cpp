// SPDX-License-Identifier: MIT
#include "app/ros1_bridge/HandDrive.h"

#include <algorithm>

namespace fodscope::bridge {
namespace {

constexpr double kHoldsFor_s = 0.3;
constexpr double kSendEvery_s = 0.05;

}  // namespace

void HandDrive::request(const Drive& speeds, double now_s) {
    speeds_ = Drive{std::clamp(speeds.forward_m_per_s, -greatestSpeed_m_per_s_, greatestSpeed_m_per_s_),
                    std::clamp(speeds.turn_rad_per_s, -greatestTurn_rad_per_s_, greatestTurn_rad_per_s_)};
    requested_s_ = now_s;
}

std::optional<Drive> HandDrive::due(double now_s) {
    if (!speeds_) return std::nullopt;
    const bool isOver =
        now_s - requested_s_ >= kHoldsFor_s || (speeds_->forward_m_per_s == 0.0 && speeds_->turn_rad_per_s == 0.0);
    if (isOver) {
        speeds_.reset();
        return Drive{};
    }
    if (now_s - sent_s_ < kSendEvery_s) return std::nullopt;
    sent_s_ = now_s;
    return speeds_;
}

}  // namespace fodscope::bridge
