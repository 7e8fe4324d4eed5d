// SPDX-License-Identifier: MIT
#include "core/detection/LeastAreaRectangle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace fodscope {
namespace {

bool turnsLeft(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    const Eigen::Vector2d first = b - a;
    const Eigen::Vector2d second = c - a;
    return first.x() * second.y() - first.y() * second.x() > 0.0;
}

/// Andrew's monotone chain: the corners counter-clockwise, none on a straight line.
std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points) {
    const auto isBefore = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
    };
    std::sort(points.begin(), points.end(), isBefore);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return points;
    std::vector<Eigen::Vector2d> hull;
    const auto addChain = [&](auto first, auto last) {
        const std::size_t start = hull.size();
        for (; first != last; ++first) {
            while (hull.size() >= start + 2 && !turnsLeft(hull[hull.size() - 2], hull.back(), *first))
                hull.pop_back();
            hull.push_back(*first);
        }
        // The last corner is the first one of the other chain.
        hull.pop_back();
    };
    addChain(points.begin(), points.end());
    addChain(points.rbegin(), points.rend());
    return hull;
}

double extentAlong(const std::vector<Eigen::Vector2d>& hull, const Eigen::Vector2d& direction) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Eigen::Vector2d& corner : hull) {
        low = std::min(low, corner.dot(direction));
        high = std::max(high, corner.dot(direction));
    }
    return high - low;
}

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
