// SPDX-License-Identifier: MIT
#include "core/cloud/Spacing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/cloud/NeighbourIndex.h"
#include "core/common/Error.h"

namespace fodscope {

double medianSpacing_m(std::span<const Eigen::Vector3d> points, Progress& progress) {
    constexpr std::size_t mostQueries = 20000;
    if (points.size() < 2) {
        throw Error("point cloud", "it has fewer than two points, so no spacing", "give a cloud with more points");
    }
    const std::size_t count = std::min(points.size(), mostQueries);
    std::vector<Eigen::Vector3d> queries(count);
    for (std::size_t i = 0; i < count; ++i)
        queries[i] = points[i * points.size() / count];
    std::vector<double> distances(count);
    // The first neighbour is the point itself, or one that coincides with it.
    const NeighbourIndex index(points, progress);
    index.forEachKNearest(
        queries, 2,
        [&](std::size_t i, std::span<const Neighbour> neighbours) {
            distances[i] = std::sqrt(neighbours[1].squaredDistance_m2);
        },
        progress);
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return *middle;
}

}  // namespace fodscope
