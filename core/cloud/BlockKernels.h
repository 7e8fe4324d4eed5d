// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>

#include "core/cloud/BlockOrder.h"
#include "core/cloud/PointBox.h"

namespace fodscope {

/// Points by axis, so that a processor computes with several at a time.
struct alignas(64) PointBlock {
    /// Coordinates by axis. Where points of an index are missing they are infinite, and so is the distance to them.
    std::array<std::array<double, kBlockSize>, 3> at;
    /// Indices of the points in the order in which they were given.
    std::array<std::uint32_t, kBlockSize> original;

    Eigen::Vector3d point(std::size_t i) const { return {at[0][i], at[1][i], at[2][i]}; }
};

/// The same for points whose coordinates are float32, as in files: nothing is lost.
struct alignas(64) SmallBlock {
    std::array<std::array<float, kBlockSize>, 3> at;
    std::array<std::uint32_t, kBlockSize> original;
};

/// Boxes by axis; missing ones are infinitely far from everything.
struct alignas(64) BoxGroup {
    std::array<std::array<double, kBlockFan>, 3> low;
    std::array<std::array<double, kBlockFan>, 3> high;
};

/// One value for each point of a block.
using BlockDistances = std::array<double, kBlockSize>;

/// Step of the sizes that `countSmaller` takes.
inline constexpr std::size_t kRankStep = 16;

/// The inner loops of the neighbour search. Each is written twice, plainly and for processors with AVX2, with the same
/// operations in the same order: both give the same bits. All distances are squared, (x·x + y·y) + z·z.
struct BlockKernels {
    /// Distances of a block's points to a point, and which of them are at most `limit` (bit i: point i), which must be
    /// finite.
    std::uint32_t (*squaredDistances)(const PointBlock& block, const Eigen::Vector3d& point, double limit,
                                      BlockDistances& distances);

    /// Appends the points of a block that are at most `limit` from a point. Writes up to kBlockSize elements behind
    /// `distances` and `indices`, whatever it finds.
    /// @return how many it found
    std::size_t (*takeWithin)(const PointBlock& block, const Eigen::Vector3d& point, double limit, double* distances,
                              std::uint32_t* indices);

    /// Distances of boxes to a box; 0 where they meet.
    void (*boxDistances)(const BoxGroup& boxes, const PointBox& box, std::array<double, kBlockFan>& distances);

    /// Which of a block's points (bit i: point i) are at most their limit from a box.
    std::uint32_t (*nearBox)(const PointBox& box, const PointBlock& points, const BlockDistances& limits);

    /// The distance from each of the points whose bit is set to the nearest point of the block; what it tells of the
    /// others is not to be used.
    /// @return which of those are at most their limit
    std::uint32_t (*leastDistances)(const PointBlock& block, const PointBlock& points, std::uint32_t wanted,
                                    const BlockDistances& limits, BlockDistances& least);

    /// Coordinates as double.
    void (*widen)(const SmallBlock& block, PointBlock& wide);

    /// counts[i]: how many keys are smaller than keys[i]. The size must be a multiple of kRankStep.
    void (*countSmaller)(std::span<const std::int16_t> keys, std::span<std::uint16_t> counts);
};

const BlockKernels& plainKernels();

/// @return nullptr when this processor has no AVX2
const BlockKernels* avx2Kernels();

/// The fastest that this processor has.
const BlockKernels& bestKernels();

}  // namespace fodscope
