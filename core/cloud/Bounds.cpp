// SPDX-License-Identifier: MIT
#include "core/cloud/Bounds.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include "core/common/Error.h"

namespace fodscope {
namespace {

/// The same pieces whatever the number of threads: which of 0 and −0 is the least depends on the order.
template <class Points>
Bounds boundsInPieces(const Points& points) {
    constexpr std::size_t piece = 1 << 15;
    return tbb::parallel_deterministic_reduce(
        tbb::blocked_range<std::size_t>(0, points.size(), piece), Bounds(),
        [&](const tbb::blocked_range<std::size_t>& range, Bounds bounds) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                Eigen::Vector3d point;
                if (!points.get(i, point)) continue;
                bounds.low = bounds.low.cwiseMin(point);
                bounds.high = bounds.high.cwiseMax(point);
                bounds.areFinite = bounds.areFinite && point.allFinite();
                ++bounds.points;
            }
            return bounds;
        },
        [](const Bounds& a, const Bounds& b) {
            return Bounds{a.low.cwiseMin(b.low), a.high.cwiseMax(b.high), a.points + b.points,
                          a.areFinite && b.areFinite};
        });
}

}  // namespace

Bounds boundsOf(std::span<const Eigen::Vector3d> points) {
    return boundsInPieces(UnmovedPoints{points});
}

Bounds boundsOf(const MovedPoints& points) {
    return boundsInPieces(points);
}

Eigen::Vector3d minimumCorner(std::span<const Eigen::Vector3d> points) {
    if (points.empty()) throw Error("point cloud", "it has no points", "give a cloud with points");
    return boundsOf(points).low;
}

Eigen::Vector3d maximumCorner(std::span<const Eigen::Vector3d> points) {
    if (points.empty()) throw Error("point cloud", "it has no points", "give a cloud with points");
    return boundsOf(points).high;
}

}  // namespace fodscope
