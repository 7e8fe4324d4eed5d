// SPDX-License-Identifier: MIT
#include "core/cloud/VoxelGrid.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "core/common/Error.h"

namespace fodscope {
namespace {

constexpr int kBitsPerAxis = 21;

void check(const VoxelGridSettings& settings) {
    if (!(settings.voxelSize_m > 0.0) || !std::isfinite(settings.voxelSize_m)) {
        throw Error("voxel size", "must be greater than 0", "give a length in metres such as 0.02");
    }
}

Eigen::Vector3d cellOf(const Eigen::Vector3d& point, const Eigen::Vector3d& origin, double size) {
    return ((point - origin).array() / size).floor();
}

using KeyedPoint = std::pair<std::uint64_t, std::uint32_t>;

/// Pairs of voxel key and point, sorted: voxels in lexicographic order and the points of each in their own order, so
/// that sums always add up in the same order.
std::vector<KeyedPoint> sortedByVoxel(std::span<const Eigen::Vector3d> points, const Eigen::Vector3d& origin,
                                      double size) {
    const Eigen::Vector3d lowest = cellOf(minimumCorner(points), origin, size);
    const Eigen::Vector3d highest = cellOf(maximumCorner(points), origin, size);
    const double cells = (highest - lowest).maxCoeff() + 1.0;
    if (!(cells <= static_cast<double>(1 << kBitsPerAxis))) {
        throw Error("voxel size", "the cloud is more than 2097152 voxels of " + std::to_string(size) + " m long",
                    "choose a larger voxel or check that the cloud is in metres");
    }
    std::vector<KeyedPoint> keyed(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector3d cell = cellOf(points[i], origin, size) - lowest;
        const auto x = static_cast<std::uint64_t>(cell.x());
        const auto y = static_cast<std::uint64_t>(cell.y());
        const auto z = static_cast<std::uint64_t>(cell.z());
        keyed[i] = {x << (2 * kBitsPerAxis) | y << kBitsPerAxis | z, static_cast<std::uint32_t>(i)};
    }
    tbb::parallel_sort(keyed.begin(), keyed.end());
    return keyed;
}

}  // namespace

VoxelCloud voxelGrid(std::span<const Eigen::Vector3d> points, const Eigen::Vector3d& origin,
                     const VoxelGridSettings& settings) {
    check(settings);
    VoxelCloud voxels;
    if (points.empty()) return voxels;
    const bool isFinite =
        std::all_of(points.begin(), points.end(), [](const auto& point) { return point.allFinite(); });
    if (!isFinite || !origin.allFinite()) {
        throw Error("point cloud", "a coordinate is not finite", "drop such points first");
    }
    const std::vector<KeyedPoint> keyed = sortedByVoxel(points, origin, settings.voxelSize_m);
    for (std::size_t first = 0; first < keyed.size();) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        std::size_t end = first;
        for (; end < keyed.size() && keyed[end].first == keyed[first].first; ++end)
            sum += points[keyed[end].second];
        voxels.points.push_back(sum / static_cast<double>(end - first));
        voxels.weights.push_back(static_cast<std::uint32_t>(end - first));
        first = end;
    }
    return voxels;
}

Eigen::Vector3d minimumCorner(std::span<const Eigen::Vector3d> points) {
    if (points.empty()) throw Error("point cloud", "it has no points", "give a cloud with points");
    Eigen::Vector3d corner = points.front();
    for (const Eigen::Vector3d& point : points)
        corner = corner.cwiseMin(point);
    return corner;
}

Eigen::Vector3d maximumCorner(std::span<const Eigen::Vector3d> points) {
    if (points.empty()) throw Error("point cloud", "it has no points", "give a cloud with points");
    Eigen::Vector3d corner = points.front();
    for (const Eigen::Vector3d& point : points)
        corner = corner.cwiseMax(point);
    return corner;
}

}  // namespace fodscope
