// SPDX-License-Identifier: MIT
#include "core/detection/CentroidLinkage.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/detection/LinkageRound.h"

namespace fodscope {
namespace {

/// How many others may share the cell of a point in the first round.
constexpr double kCrowd = 1.5;
constexpr std::size_t kLeastSample = 2048;
constexpr int kMostRounds = 60;

/// @return the greatest square whose root is within the length
double largestSquareWithin(double length_m) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double square = length_m * length_m;
    while (std::sqrt(square) > length_m)
        square = std::nextafter(square, 0.0);
    while (square < infinity && std::sqrt(std::nextafter(square, infinity)) <= length_m)
        square = std::nextafter(square, infinity);
    return square;
}

double diameter(const std::vector<LivingCluster>& clusters) {
    Eigen::Vector3d low = clusters.front().centroid;
    Eigen::Vector3d high = low;
    for (const LivingCluster& cluster : clusters) {
        low = low.cwiseMin(cluster.centroid);
        high = high.cwiseMax(cluster.centroid);
    }
    return (high - low).norm();
}

/// About how many others share a cell with a cluster, from a sample.
double crowding(const std::vector<LivingCluster>& clusters, double cell_m) {
    const std::size_t wanted = std::max(kLeastSample, clusters.size() / 64);
    const std::size_t stride = std::max<std::size_t>(1, clusters.size() / wanted);
    std::vector<std::uint64_t> cells;
    for (std::size_t i = 0; i < clusters.size(); i += stride) {
        const Eigen::Vector3d at = clusters[i].centroid / cell_m;
        std::uint64_t cell = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double bounded = std::clamp(std::floor(at[axis]), -1e15, 1e15);
            cell = (cell ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(bounded))) * 0x9E3779B97F4A7C15u;
            cell ^= cell >> 29;
        }
        cells.push_back(cell);
    }
    std::ranges::sort(cells);
    double others = 0.0;
    std::size_t first = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i] != cells[first]) first = i;
        others += 2.0 * static_cast<double>(i - first);
    }
    return others / static_cast<double>(cells.size()) * static_cast<double>(stride);
}

}  // namespace

double firstReach(const std::vector<LivingCluster>& clusters, double largest_m, double denser) {
    double reach_m = std::min(largest_m, 1.01 * diameter(clusters));
    for (int round = 0; round < kMostRounds && denser * crowding(clusters, reach_m) > kCrowd; ++round)
        reach_m /= kRoundStep;
    return reach_m;
}

void CentroidAgglomeration::advance(double cutoff_m, std::vector<Merge>& merges, Progress& progress) {
    progress.report("clustering", 0.0);
    if (living_.size() < 2 || cutoff_m == 0.0) return;
    const std::size_t points = living_.size();
    const double last_m = std::min(cutoff_m, 1.01 * diameter(living_));
    for (double reach_m = firstReach(living_, last_m); living_.size() > 1; reach_m *= kRoundStep) {
        const bool isLast = reach_m * 1.0001 >= last_m;
        const LinkageProgress soFar{progress, points - living_.size(), points};
        const std::vector<RoundMerge> found = runRound(
            living_, isLast ? last_m : reach_m, isLast ? largestSquareWithin(cutoff_m) : reach_m * reach_m, soFar);
        for (const RoundMerge& merge : found)
            merges.push_back({merge.kept, merge.removed, std::sqrt(merge.squaredDistance)});
        if (isLast) break;
    }
}

}  // namespace fodscope
