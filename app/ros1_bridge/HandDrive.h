// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/bridge/BridgeProtocol.h"

namespace fodscope::bridge {

/// Driving by hand. A speed holds as long as it is repeated; then the robot is told to stand, once, and left alone.
class HandDrive {
  public:
    HandDrive(double greatestSpeed_m_per_s, double greatestTurn_rad_per_s)
        : greatestSpeed_m_per_s_(greatestSpeed_m_per_s), greatestTurn_rad_per_s_(greatestTurn_rad_per_s) {}

    void request(const Drive& speeds, double now_s);
    /// @return what to send now, held to the limits, if anything
    std::optional<Drive> due(double now_s);
    bool isDriving() const { return speeds_.has_value(); }

  private:
    double greatestSpeed_m_per_s_;
    double greatestTurn_rad_per_s_;
    std::optional<Drive> speeds_;
    double requested_s_ = 0.0;
    double sent_s_ = -1e9;
};

}  // namespace fodscope::bridge
