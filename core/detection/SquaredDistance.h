// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace fodscope {

/// Squared distance whose every part is computed in the same order wherever it is needed, so that equal distances
/// compare as equal.
inline double squaredDistance(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const double x = a.x() - b.x();
    const double y = a.y() - b.y();
    const double z = a.z() - b.z();
    return x * x + y * y + z * z;
}

}  // namespace fodscope
