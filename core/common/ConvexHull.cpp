// SPDX-License-Identifier: MIT
#include "core/common/ConvexHull.h"

#include <algorithm>
#include <limits>

namespace fodscope {
namespace {

bool turnsLeft(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    const Eigen::Vector2d first = b - a;
    const Eigen::Vector2d second = c - a;
    return first.x() * second.y() - first.y() * second.x() > 0.0;
}

}  // namespace

// Andrew's monotone chain.
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

}  // namespace fodscope
