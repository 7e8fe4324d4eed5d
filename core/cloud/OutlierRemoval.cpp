// SPDX-License-Identifier: MIT
#include "core/cloud/OutlierRemoval.h"

#include <cmath>
#include <numeric>

#include "core/cloud/NeighbourIndex.h"
#include "core/common/Error.h"

namespace fodscope {
namespace {

void check(const OutlierRemovalSettings& settings) {
    if (settings.neighbours < 1) {
        throw Error("denoise.neighbours", "must be at least 1, not " + std::to_string(settings.neighbours),
                    "give a whole number such as 50");
    }
    if (!(settings.standardDeviations > 0.0) || !std::isfinite(settings.standardDeviations)) {
        throw Error("denoise.standardDeviations", "must be greater than 0", "give a number such as 2.0");
    }
}

std::vector<std::uint32_t> everything(std::size_t count) {
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

/// Each point's mean distance to its nearest.
std::vector<double> meanDistances_m(std::span<const Eigen::Vector3d> points, const OutlierRemovalSettings& settings,
                                    Progress& progress, const std::string& stage) {
    const NeighbourIndex index(points, progress);
    std::vector<double> means_m(points.size());
    index.forEachKNearest(
        points, static_cast<std::size_t>(settings.neighbours),
        [&](std::size_t i, std::span<const Neighbour> neighbours) {
            double sum = 0.0;
            for (const Neighbour& neighbour : neighbours)
                sum += std::sqrt(neighbour.squaredDistance_m2);
            means_m[i] = sum / static_cast<double>(neighbours.size());
        },
        progress, stage);
    return means_m;
}

}  // namespace

std::vector<std::uint32_t> keptByOutlierRemoval(std::span<const Eigen::Vector3d> points,
                                                const OutlierRemovalSettings& settings, Progress& progress,
                                                const std::string& stage) {
    if (settings.enabled) check(settings);
    // With fewer than two points there is no spread to judge by.
    if (!settings.enabled || points.size() < 2) return everything(points.size());

    const std::vector<double> distances_m = meanDistances_m(points, settings, progress, stage);
    const double count = static_cast<double>(points.size());
    const double mean = std::accumulate(distances_m.begin(), distances_m.end(), 0.0) / count;
    double squares = 0.0;
    for (const double distance_m : distances_m)
        squares += (distance_m - mean) * (distance_m - mean);
    const double limit = mean + settings.standardDeviations * std::sqrt(squares / (count - 1.0));
    // Equally spaced points have no spread: none of them is an outlier.
    if (squares == 0.0) return everything(points.size());
    std::vector<std::uint32_t> kept;
    kept.reserve(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i)
        if (distances_m[i] < limit) kept.push_back(i);
    return kept;
}

PointCloud select(const PointCloud& cloud, std::span<const std::uint32_t> indices) {
    PointCloud selected;
    selected.droppedNonFinite = cloud.droppedNonFinite;
    selected.points.reserve(indices.size());
    for (const std::uint32_t index : indices)
        selected.points.push_back(cloud.points[index]);
    if (!cloud.colours.empty()) {
        selected.colours.reserve(indices.size());
        for (const std::uint32_t index : indices)
            selected.colours.push_back(cloud.colours[index]);
    }
    return selected;
}

void keepOnly(PointCloud& cloud, std::span<const std::uint32_t> indices) {
    const bool hasColours = !cloud.colours.empty();
    for (std::size_t i = 0; i < indices.size(); ++i) {
        cloud.points[i] = cloud.points[indices[i]];
        if (hasColours) cloud.colours[i] = cloud.colours[indices[i]];
    }
    cloud.points.resize(indices.size());
    if (hasColours) cloud.colours.resize(indices.size());
}

}  // namespace fodscope
