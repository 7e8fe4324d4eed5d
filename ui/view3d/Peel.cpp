// SPDX-License-Identifier: MIT
#include "ui/view3d/Peel.h"

#include <algorithm>
#include <limits>

namespace fodscope {
namespace {

/// Walls alone put a tenth of their points into the top tenth of the height; a deck adds many more.
constexpr double kTopShare = 0.1;
constexpr double kClosedShare = 0.15;
constexpr double kOpenedShare = 0.78;
constexpr std::size_t kLeastPoints = 100;

}  // namespace

std::optional<double> openingHeight(std::span<const Eigen::Vector3d> points) {
    if (points.size() < kLeastPoints) return std::nullopt;
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    for (const auto& point : points) {
        lowest = std::min(lowest, point.z());
        highest = std::max(highest, point.z());
    }
    const double height = highest - lowest;
    const double top = highest - kTopShare * height;
    const auto above = std::count_if(points.begin(), points.end(), [top](const auto& p) { return p.z() > top; });
    if (height <= 0.0 || static_cast<double>(above) < kClosedShare * static_cast<double>(points.size())) {
        return std::nullopt;
    }
    return lowest + kOpenedShare * height;
}

}  // namespace fodscope
