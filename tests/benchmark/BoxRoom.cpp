// SPDX-License-Identifier: MIT
#include "tests/benchmark/BoxRoom.h"

#include <cmath>
#include <random>

namespace fodscope {

std::vector<Eigen::Vector3d> boxRoom(std::size_t count, std::uint64_t seed) {
    std::mt19937_64 generator(seed);
    const double edge_m = std::sqrt(static_cast<double>(count) / 6.0 * 1e-4);
    std::uniform_real_distribution<double> along(0.0, edge_m);
    std::normal_distribution<double> noise(0.0, 0.01);
    std::vector<Eigen::Vector3d> points(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto axis = static_cast<Eigen::Index>(i % 3);
        Eigen::Vector3d& point = points[i];
        for (Eigen::Index other = 0; other < 3; ++other)
            point[other] = along(generator);
        point[axis] = (i / 3) % 2 == 0 ? 0.0 : edge_m;
        for (Eigen::Index other = 0; other < 3; ++other)
            point[other] += noise(generator);
    }
    return points;
}

}  // namespace fodscope
