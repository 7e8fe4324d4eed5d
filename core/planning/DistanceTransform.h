// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace fodscope {

inline constexpr std::int32_t kNoSourceNear = std::numeric_limits<std::int32_t>::max();

/// Exact squared Euclidean distance, in cells, from every cell's centre to the nearest source cell's (the two-pass
/// transform of Meijster, in integers). Work does not grow with the limit.
/// @param isSource row-major, width × height, non-zero for sources
/// @param limit_cells cells farther than this get kNoSourceNear
std::vector<std::int32_t> squaredCellDistances(std::span<const std::uint8_t> isSource, int width, int height,
                                               int limit_cells);

}  // namespace fodscope
