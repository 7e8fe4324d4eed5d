// SPDX-License-Identifier: MIT
#include "core/cloud/MortonOrder.h"

#include <algorithm>
#include <utility>

namespace fodscope {
namespace {

/// Spreads the low 21 bits so that two zero bits follow each.
std::uint64_t spreadBits(std::uint64_t value) {
    value &= 0x1fffff;
    value = (value | value << 32) & 0x1f00000000ffff;
    value = (value | value << 16) & 0x1f0000ff0000ff;
    value = (value | value << 8) & 0x100f00f00f00f00f;
    value = (value | value << 4) & 0x10c30c30c30c30c3;
    value = (value | value << 2) & 0x1249249249249249;
    return value;
}

}  // namespace

std::vector<std::uint32_t> mortonOrder(std::span<const Eigen::Vector3d> points) {
    if (points.empty()) return {};
    Eigen::Vector3d low = points.front();
    Eigen::Vector3d high = points.front();
    for (const Eigen::Vector3d& point : points) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    // Halved before subtracting: the extent of points near the largest double would overflow.
    const double halfExtent = (0.5 * high - 0.5 * low).maxCoeff();
    const double steps = static_cast<double>((1 << 21) - 1);
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::uint64_t key = 0;
        for (int axis = 0; axis < 3 && halfExtent > 0.0; ++axis) {
            const double fraction = (0.5 * points[i][axis] - 0.5 * low[axis]) / halfExtent;
            const double step = std::clamp(fraction * steps, 0.0, steps);
            key |= spreadBits(static_cast<std::uint64_t>(step)) << axis;
        }
        keys[i] = {key, static_cast<std::uint32_t>(i)};
    }
    std::sort(keys.begin(), keys.end());
    std::vector<std::uint32_t> order(points.size());
    std::transform(keys.begin(), keys.end(), order.begin(), [](const auto& key) { return key.second; });
    return order;
}

}  // namespace fodscope
