// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>
#include <vector>

namespace fodscope {

/// Points in the unit cube. std::mt19937_64 gives the same bits everywhere; the standard distributions do not.
inline std::vector<Eigen::Vector3d> randomPoints(std::size_t count, std::uint64_t seed) {
    std::mt19937_64 generator(seed);
    const auto unit = [&] { return static_cast<double>(generator() >> 11) * 0x1.0p-53; };
    std::vector<Eigen::Vector3d> points(count);
    for (Eigen::Vector3d& point : points) {
        point.x() = unit();
        point.y() = unit();
        point.z() = unit();
    }
    return points;
}

}  // namespace fodscope
