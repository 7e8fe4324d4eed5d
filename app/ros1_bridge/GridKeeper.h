// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "app/ros1_bridge/RosMessages.h"
#include "core/bridge/BridgeProtocol.h"

namespace fodscope::bridge {

/// A grid with the updates that came after it. costmap_2d sends the whole only once.
class GridKeeper {
  public:
    explicit GridKeeper(bool isCostMap) { grid_.isCostMap = isCostMap; }

    /// @throws Error for one that cannot be: no cells, absurd sizes, fewer cells than announced, no resolution
    void take(const GridMessage& message);
    /// @throws Error for one that reaches over the grid's edge or has too few cells; the grid stays as it was
    void apply(const GridUpdateMessage& update);

    bool isThere() const { return !grid_.cells.empty(); }
    /// Of the robot, e.g. "map".
    const std::string& frame() const { return frame_; }
    /// @param T_map_from_grid where the grid's frame is not the map frame
    Grid grid(const std::optional<Rows>& T_map_from_grid) const;

  private:
    Grid grid_;
    std::string frame_;
    Rows T_frame_from_origin_{};
};

/// @param pose position x, y, z and orientation x, y, z, w
/// @throws Error when a number is not finite or the orientation is none
Rows rowsOfPose(const std::array<double, 7>& pose, const std::string& subject);
Rows product(const Rows& first, const Rows& second);
PlanarPose planarPartOf(const Rows& transform);

}  // namespace fodscope::bridge
