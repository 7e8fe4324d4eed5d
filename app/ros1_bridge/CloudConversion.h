// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "app/ros1_bridge/RosMessages.h"
#include "core/bridge/BridgeProtocol.h"

namespace fodscope::bridge {

/// Reads a PointCloud2 of any layout: fields in any order and of any number type, padding, rows that are longer than
/// their points, both byte orders, rgb or rgba. Points with a coordinate that is not finite are dropped and counted.
/// @param T_map_from_cloud moves the points; missing: they are in the map frame already
/// @throws Error when it lacks x, y or z, its sizes contradict each other, or it has no finite point
MapCloud mapCloudOf(const CloudMessage& message, const std::optional<Rows>& T_map_from_cloud);

}  // namespace fodscope::bridge
