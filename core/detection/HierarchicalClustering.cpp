// SPDX-License-Identifier: MIT
#include "core/detection/HierarchicalClustering.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "core/common/Error.h"
#include "core/detection/CentroidLinkage.h"
#include "core/detection/Places.h"
#include "core/detection/SingleLinkage.h"

namespace fodscope {
namespace {

void checkCutoff(double cutoff_m) {
    if (!(cutoff_m >= 0.0) || !std::isfinite(cutoff_m)) {
        throw Error("cluster cutoff", "must be a finite length of at least 0 m", "give for example 0.345");
    }
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

GrowingMergeSequence::GrowingMergeSequence(std::span<const Eigen::Vector3d> points, Linkage linkage)
    : linkage_(linkage) {
    requireFinite(points);
    Places places = placesOf(points);
    sequence_ = {points.size(), 0.0, std::move(places.merges)};
    samePlaceMerges_ = sequence_.merges.size();
    clusters_ = std::move(places.clusters);
}

GrowingMergeSequence::~GrowingMergeSequence() = default;
GrowingMergeSequence::GrowingMergeSequence(GrowingMergeSequence&&) noexcept = default;
GrowingMergeSequence& GrowingMergeSequence::operator=(GrowingMergeSequence&&) noexcept = default;

const MergeSequence& GrowingMergeSequence::upTo(double cutoff_m, Progress& progress) {
    checkCutoff(cutoff_m);
    progress.throwIfCancelled();
    if (cutoff_m <= sequence_.largestCutoff_m) return sequence_;
    if (linkage_ == Linkage::Single) {
        sequence_.merges.resize(samePlaceMerges_);
        appendSingleMerges(clusters_, cutoff_m, sequence_.merges, progress);
    } else {
        CentroidAgglomeration agglomeration(std::exchange(clusters_, {}));
        agglomeration.advance(cutoff_m, sequence_.merges, progress);
        clusters_ = agglomeration.release();
    }
    sequence_.largestCutoff_m = cutoff_m;
    return sequence_;
}

MergeSequence GrowingMergeSequence::release() && {
    return std::move(sequence_);
}

MergeSequence mergeSequence(std::span<const Eigen::Vector3d> points, Linkage linkage, double largestCutoff_m,
                            Progress& progress) {
    checkCutoff(largestCutoff_m);
    progress.throwIfCancelled();
    GrowingMergeSequence sequence(points, linkage);
    sequence.upTo(largestCutoff_m, progress);
    return std::move(sequence).release();
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
