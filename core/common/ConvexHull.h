// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace fodscope {

/// Convex hull in the plane: the corners counter-clockwise, none on a straight line. Fewer than three distinct points
/// come back as they are, points on a line as its two ends.
std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points);

/// @return how far the hull reaches along a unit direction
double extentAlong(const std::vector<Eigen::Vector2d>& hull, const Eigen::Vector2d& direction);

}  // namespace fodscope
