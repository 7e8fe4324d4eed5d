// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace fodscope {

/// length ≥ width; both may be 0.
struct OrientedRectangle {
    double length_m = 0.0;
    double width_m = 0.0;
    /// Direction of the length, in (−π/2, π/2].
    double direction_rad = 0.0;
};

/// The rectangle of least area round the points. One of its sides lies on a side of the convex hull.
/// Source: Freeman and Shapira, "Determining the minimum-area encasing rectangle" (1975).
OrientedRectangle leastAreaRectangle(std::vector<Eigen::Vector2d> points);

}  // namespace fodscope
