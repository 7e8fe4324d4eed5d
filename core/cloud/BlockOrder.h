// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace fodscope {

/// Points per block.
inline constexpr std::size_t kBlockSize = 16;
/// Blocks, and groups of blocks, that are beside each other in space.
inline constexpr std::size_t kBlockFan = 8;

/// A point with its index: what sorting moves about, so that it need not look the points up.
struct PlacedPoint {
    std::array<double, 3> at;
    std::uint32_t index;
};

std::vector<PlacedPoint> placedPoints(std::span<const Eigen::Vector3d> points, std::span<const std::uint32_t> indices);

/// Puts points into blocks of 16 that are compact in space, and each 8 blocks beside each other, and each 8 of these,
/// and so on: halves at the median of the longest side (as a kd-tree does), cut where a block ends. Only the last block
/// may be short. Meant for as many points as fit into the cache. All coordinates must be finite.
void orderInBlocks(std::span<PlacedPoint> points);

}  // namespace fodscope
