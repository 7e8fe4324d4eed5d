// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <span>

#include "core/cloud/MovedPoints.h"

namespace fodscope {

/// The least box round some points; without points its corners are infinite and the wrong way round.
struct Bounds {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d high = Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());
    std::size_t points = 0;
    /// False when a coordinate is NaN or infinite; the corners then mean nothing.
    bool areFinite = true;
};

/// In parallel.
Bounds boundsOf(std::span<const Eigen::Vector3d> points);
Bounds boundsOf(const MovedPoints& points);

/// @return the least coordinate on each axis
/// @throws Error when there are no points
Eigen::Vector3d minimumCorner(std::span<const Eigen::Vector3d> points);
Eigen::Vector3d maximumCorner(std::span<const Eigen::Vector3d> points);

}  // namespace fodscope
