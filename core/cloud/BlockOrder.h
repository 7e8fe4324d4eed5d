// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace fodscope {

/// Points per block of blockOrder().
inline constexpr std::size_t kBlockSize = 16;
/// Blocks, and groups of blocks, that are beside each other in space.
inline constexpr std::size_t kBlockFan = 8;

/// Puts points into blocks of 16 that are compact in space, and each 8 blocks beside each other, and each 8 of these,
/// and so on: halves at the median of the longest side (as a kd-tree does), cut where a block ends. Work that is done
/// in this order finds its data in the cache. All coordinates must be finite.
/// @return the indices of the points, block by block; only the last block may be short
std::vector<std::uint32_t> blockOrder(std::span<const Eigen::Vector3d> points);

}  // namespace fodscope
