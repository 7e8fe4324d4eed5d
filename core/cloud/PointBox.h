// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <limits>

namespace fodscope {

/// The box round points, along the axes.
struct PointBox {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d high = Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());

    void add(const Eigen::Vector3d& point) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    void add(const PointBox& other) {
        low = low.cwiseMin(other.low);
        high = high.cwiseMax(other.high);
    }
    /// The first of the longest.
    Eigen::Index longestSide() const {
        Eigen::Index longest = 0;
        // Halved before subtracting: the extent of points near the largest double would overflow.
        (0.5 * high - 0.5 * low).maxCoeff(&longest);
        return longest;
    }
};

}  // namespace fodscope
