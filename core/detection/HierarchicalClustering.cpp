// SPDX-License-Identifier: MIT
#include "core/detection/HierarchicalClustering.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>

#include "core/common/Error.h"
#include "core/detection/CentroidLinkage.h"
#include "core/detection/SingleLinkage.h"

namespace fodscope {
namespace {

void checkCutoff(double cutoff_m) {
    if (!(cutoff_m >= 0.0) || !std::isfinite(cutoff_m)) {
        throw Error("cluster cutoff", "must be a finite length of at least 0 m", "give for example 0.345");
    }
}

void checkPoints(std::span<const Eigen::Vector3d> points) {
    if (points.size() > std::numeric_limits<std::uint32_t>::max()) {
        throw Error("points to cluster", "are more than 4 billion", "raise the threshold");
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].allFinite()) continue;
        throw Error("points to cluster", "number " + std::to_string(i) + " has a coordinate that is not finite",
                    "drop such points first");
    }
}

/// Points at the same place are merged at distance 0 before anything else and their centroid does not move, so they
/// may start as one cluster with a weight. Places are in the order of their first points.
struct Places {
    std::vector<Eigen::Vector3d> positions;
    std::vector<double> weights;
    std::vector<std::uint32_t> firstPoint;
    /// Those that make the places.
    std::vector<Merge> merges;
};

Places placesOf(std::span<const Eigen::Vector3d> points) {
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t i) { return std::tie(points[i].x(), points[i].y(), points[i].z()); };
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b) || (key(a) == key(b) && a < b); });
    std::vector<std::uint32_t> first(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool isSame = i > 0 && key(order[i]) == key(order[i - 1]);
        first[order[i]] = isSame ? first[order[i - 1]] : order[i];
    }
    Places places;
    std::vector<std::uint32_t> placeOfPoint(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        if (first[i] == i) {
            placeOfPoint[i] = static_cast<std::uint32_t>(places.positions.size());
            places.positions.push_back(points[i]);
            places.weights.push_back(1.0);
            places.firstPoint.push_back(i);
        } else {
            places.weights[placeOfPoint[first[i]]] += 1.0;
            places.merges.push_back({first[i], i, 0.0});
        }
    }
    // The pair with the lowest first point goes first.
    std::ranges::stable_sort(places.merges, {}, &Merge::kept);
    return places;
}

}  // namespace

MergeSequence mergeSequence(std::span<const Eigen::Vector3d> points, Linkage linkage, double largestCutoff_m,
                            Progress& progress) {
    checkCutoff(largestCutoff_m);
    checkPoints(points);
    progress.throwIfCancelled();
    MergeSequence sequence{points.size(), largestCutoff_m, {}};
    if (points.empty()) return sequence;
    Places places = placesOf(points);
    const std::vector<Merge> later = linkage == Linkage::Single
                                         ? singleMerges(places.positions, largestCutoff_m, progress)
                                         : centroidMerges(places.positions, places.weights, largestCutoff_m, progress);
    sequence.merges = std::move(places.merges);
    sequence.merges.reserve(sequence.merges.size() + later.size());
    for (const Merge& merge : later)
        sequence.merges.push_back({places.firstPoint[merge.kept], places.firstPoint[merge.removed], merge.distance_m});
    return sequence;
}

std::vector<std::uint32_t> clustersAt(const MergeSequence& sequence, double cutoff_m) {
    checkCutoff(cutoff_m);
    if (cutoff_m > sequence.largestCutoff_m) {
        throw Error("cluster cutoff", "is greater than the largest that was clustered for", "cluster anew");
    }
    std::vector<std::uint32_t> parents(sequence.pointCount);
    std::iota(parents.begin(), parents.end(), 0u);
    for (const Merge& merge : sequence.merges) {
        if (merge.distance_m > cutoff_m) break;
        parents[merge.removed] = merge.kept;
    }
    // A parent is lower than its child, so its label is known before it is needed.
    std::vector<std::uint32_t> labels(sequence.pointCount);
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < labels.size(); ++i)
        labels[i] = parents[i] == i ? next++ : labels[parents[i]];
    return labels;
}

std::vector<std::uint32_t> linkageClusters(std::span<const Eigen::Vector3d> points, Linkage linkage, double cutoff_m,
                                           Progress& progress) {
    return clustersAt(mergeSequence(points, linkage, cutoff_m, progress), cutoff_m);
}

}  // namespace fodscope
