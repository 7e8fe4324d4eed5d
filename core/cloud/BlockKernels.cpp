// SPDX-License-Identifier: MIT
#include "core/cloud/BlockKernels.h"

#include <algorithm>
#include <limits>

namespace fodscope {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::uint32_t squaredDistances(const PointBlock& block, const Eigen::Vector3d& point, double limit,
                               BlockDistances& distances) {
    std::uint32_t within = 0;
    for (std::size_t i = 0; i < kBlockSize; ++i) {
        const double x = block.at[0][i] - point.x();
        const double y = block.at[1][i] - point.y();
        const double z = block.at[2][i] - point.z();
        distances[i] = x * x + y * y + z * z;
        within |= (distances[i] <= limit ? 1U : 0U) << i;
    }
    return within;
}

std::size_t takeWithin(const PointBlock& block, const Eigen::Vector3d& point, double limit, double* distances,
                       std::uint32_t* indices) {
    std::size_t count = 0;
    BlockDistances all;
    squaredDistances(block, point, limit, all);
    for (std::size_t i = 0; i < kBlockSize; ++i) {
        distances[count] = all[i];
        indices[count] = block.original[i];
        count += all[i] <= limit ? 1 : 0;
    }
    return count;
}

void boxDistances(const BoxGroup& boxes, const PointBox& box, std::array<double, kBlockFan>& distances) {
    distances.fill(0.0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double low = box.low[static_cast<Eigen::Index>(axis)];
        const double high = box.high[static_cast<Eigen::Index>(axis)];
        for (std::size_t i = 0; i < kBlockFan; ++i) {
            const double gap = std::max(std::max(boxes.low[axis][i] - high, low - boxes.high[axis][i]), 0.0);
            distances[i] += gap * gap;
        }
    }
}

std::uint32_t nearBox(const PointBox& box, const PointBlock& points, const BlockDistances& limits) {
    BlockDistances distances{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double low = box.low[static_cast<Eigen::Index>(axis)];
        const double high = box.high[static_cast<Eigen::Index>(axis)];
        for (std::size_t i = 0; i < kBlockSize; ++i) {
            const double gap = std::max(std::max(low - points.at[axis][i], points.at[axis][i] - high), 0.0);
            distances[i] += gap * gap;
        }
    }
    std::uint32_t near = 0;
    for (std::size_t i = 0; i < kBlockSize; ++i)
        near |= (distances[i] <= limits[i] ? 1U : 0U) << i;
    return near;
}

std::uint32_t leastDistances(const PointBlock& block, const PointBlock& points, std::uint32_t wanted,
                             const BlockDistances& limits, BlockDistances& least) {
    least.fill(kInfinity);
    BlockDistances distances;
    std::uint32_t within = 0;
    for (std::size_t i = 0; i < kBlockSize; ++i) {
        if ((wanted >> i & 1U) == 0) continue;
        squaredDistances(block, points.point(i), 0.0, distances);
        for (const double distance : distances)
            least[i] = std::min(least[i], distance);
        within |= (least[i] <= limits[i] ? 1U : 0U) << i;
    }
    return within;
}

void widen(const SmallBlock& block, PointBlock& wide) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        std::ranges::copy(block.at[axis], wide.at[axis].begin());
    wide.original = block.original;
}

void countSmaller(std::span<const std::int16_t> keys, std::span<std::uint16_t> counts) {
    std::ranges::fill(counts, std::uint16_t{0});
    for (const std::int16_t other : keys) {
        for (std::size_t i = 0; i < keys.size(); ++i)
            counts[i] = static_cast<std::uint16_t>(counts[i] + (other < keys[i] ? 1 : 0));
    }
}

}  // namespace

const BlockKernels& plainKernels() {
    static constexpr BlockKernels kernels{squaredDistances, takeWithin, boxDistances, nearBox,
                                          leastDistances,   widen,      countSmaller};
    return kernels;
}

const BlockKernels& bestKernels() {
    static const BlockKernels& best = avx2Kernels() != nullptr ? *avx2Kernels() : plainKernels();
    return best;
}

}  // namespace fodscope
