// SPDX-License-Identifier: MIT
#include "core/detection/LeastAreaRectangle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/common/ConvexHull.h"

namespace fodscope {
namespace {

double halfTurn(double angle_rad) {
    if (angle_rad > std::numbers::pi / 2.0) return angle_rad - std::numbers::pi;
    if (angle_rad <= -std::numbers::pi / 2.0) return angle_rad + std::numbers::pi;
    return angle_rad;
}

}  // namespace

OrientedRectangle leastAreaRectangle(std::vector<Eigen::Vector2d> points) {
    const std::vector<Eigen::Vector2d> hull = convexHull(std::move(points));
    OrientedRectangle least;
    if (hull.size() < 2) return least;
    double leastArea = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Eigen::Vector2d side = (hull[(i + 1) % hull.size()] - hull[i]).normalized();
        const Eigen::Vector2d across(-side.y(), side.x());
        const double along = extentAlong(hull, side);
        const double width = extentAlong(hull, across);
        if (along * width >= leastArea) continue;
        leastArea = along * width;
        const Eigen::Vector2d& longer = along >= width ? side : across;
        least = {std::max(along, width), std::min(along, width), halfTurn(std::atan2(longer.y(), longer.x()))};
    }
    return least;
}

}  // namespace fodscope
