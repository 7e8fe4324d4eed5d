// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "core/cloud/BlockOrder.h"

namespace fodscope {

// The inner loops of the neighbour search. Each is written twice, plainly and for processors with AVX2, with the same
// operations in the same order: both give the same bits.

struct alignas(64) PointBlock {
    /// Coordinates by axis. Where points are missing they are infinite, and so is the distance to them.
    std::array<std::array<double, kBlockSize>, 3> at;
    /// Indices of the points in the order in which they were given.
    std::array<std::uint32_t, kBlockSize> original;
};

/// Boxes by axis; missing ones are infinitely far from everything.
struct alignas(64) BoxGroup {
    std::array<std::array<double, kBlockFan>, 3> low;
    std::array<std::array<double, kBlockFan>, 3> high;
};

struct PointBox {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d high = Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());

    void add(const Eigen::Vector3d& point) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
};

using BlockDistances = std::array<double, kBlockSize>;

/// Squared distances of a block's points to a point, and which of them are at most `limit` (bit i: point i). `limit`
/// must be finite.
std::uint32_t squaredDistances(const PointBlock& block, const Eigen::Vector3d& point, double limit,
                               BlockDistances& distances);

/// Squared distances of boxes to a box; 0 where they meet.
void squaredDistances(const BoxGroup& boxes, const PointBox& box, std::array<double, kBlockFan>& distances);

/// Step of the sizes that countSmaller() takes.
inline constexpr std::size_t kRankStep = 16;

/// counts[i]: how many keys are smaller than keys[i]. The size must be a multiple of kRankStep; fill up with infinity.
void countSmaller(std::span<const float> keys, std::span<std::uint32_t> counts);

}  // namespace fodscope
