// SPDX-License-Identifier: MIT
#include "core/detection/HierarchicalClustering.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

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
/// may start as one cluster with a count. Places are in the order of their first points, which are their ids.
struct Places {
    std::vector<LivingCluster> clusters;
    /// Those that make the places.
    std::vector<Merge> merges;
};

std::uint64_t hashOf(const Eigen::Vector3d& point) {
    std::uint64_t hash = 0;
    for (const double coordinate : {point.x(), point.y(), point.z()}) {
        // Negative zero is the same place.
        hash = (hash ^ std::bit_cast<std::uint64_t>(coordinate + 0.0)) * 0x9E3779B97F4A7C15u;
        hash ^= hash >> 32;
    }
    return hash;
}

Places placesOf(std::span<const Eigen::Vector3d> points) {
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    Places places;
    places.clusters.reserve(points.size());
    std::vector<std::uint32_t> table(std::bit_ceil(2 * points.size()), none);
    const std::uint64_t mask = table.size() - 1;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        std::uint64_t at = hashOf(points[i]) & mask;
        while (table[at] != none && places.clusters[table[at]].centroid != points[i])
            at = (at + 1) & mask;
        if (table[at] == none) {
            table[at] = static_cast<std::uint32_t>(places.clusters.size());
            places.clusters.push_back({points[i], i, 1});
        } else {
            LivingCluster& place = places.clusters[table[at]];
            ++place.count;
            places.merges.push_back({place.id, i, 0.0});
        }
    }
    // The pair with the lowest first point goes first.
    std::ranges::stable_sort(places.merges, {}, &Merge::kept);
    return places;
}

/// Single linkage knows places by their position in the list.
void appendSingleMerges(const std::vector<LivingCluster>& places, double cutoff_m, std::vector<Merge>& merges,
                        Progress& progress) {
    std::vector<Eigen::Vector3d> positions;
    positions.reserve(places.size());
    for (const LivingCluster& place : places)
        positions.push_back(place.centroid);
    for (const Merge& merge : singleMerges(positions, cutoff_m, progress))
        merges.push_back({places[merge.kept].id, places[merge.removed].id, merge.distance_m});
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
    sequence.merges = std::move(places.merges);
    if (linkage == Linkage::Single)
        appendSingleMerges(places.clusters, largestCutoff_m, sequence.merges, progress);
    else
        CentroidAgglomeration(std::move(places.clusters)).advance(largestCutoff_m, sequence.merges, progress);
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
