// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/common/Progress.h"

namespace fodscope {

/// How far two clusters are from each other.
enum class Linkage {
    Centroid,  ///< the paper: the distance of their centroids, every point counting 1
    Single     ///< the authors' published code: the distance of their two nearest points
};

/// Two clusters, each named by its first point, become one, named `kept` (the lower).
struct Merge {
    std::uint32_t kept = 0;
    std::uint32_t removed = 0;
    double distance_m = 0.0;

    bool operator==(const Merge&) const = default;
};

/// The merges of an agglomeration in the order in which they happen, up to a largest cutoff.
struct MergeSequence {
    std::size_t pointCount = 0;
    double largestCutoff_m = 0.0;
    std::vector<Merge> merges;
};

/// Agglomerative clustering: the closest two clusters become one, over and over, while they are at most the cutoff
/// apart. Exact, in memory that grows with n.
///
/// Ties: distances are compared as squares, (xa−xb)² + (ya−yb)² + (za−zb)² summed in that order in double precision. Of
/// pairs at the same distance the one goes first whose lower first point is the lowest, then the one whose other first
/// point is. Centroid linkage moves the centroid a of the cluster with the lower first point to a + (b−a)·nb/(na+nb).
/// For single linkage no rule is needed: its clusters at a cutoff are the same in whatever order ties are merged.
/// Points at the same place merge first, at distance 0.
///
/// @throws Error when a point is not finite, or the cutoff negative or not finite; Cancelled
MergeSequence mergeSequence(std::span<const Eigen::Vector3d> points, Linkage linkage, double largestCutoff_m,
                            Progress& progress);

struct LivingCluster;

/// A merge sequence that goes on from where it is when a greater cutoff is asked for.
class GrowingMergeSequence {
  public:
    /// @throws Error when a point is not finite
    GrowingMergeSequence(std::span<const Eigen::Vector3d> points, Linkage linkage);
    ~GrowingMergeSequence();
    GrowingMergeSequence(GrowingMergeSequence&&) noexcept;
    GrowingMergeSequence& operator=(GrowingMergeSequence&&) noexcept;

    /// @return the merges up to the cutoff or beyond it: what mergeSequence() gives. When it throws Cancelled, the
    ///         sequence is of no more use
    /// @throws Error when the cutoff is negative or not finite; Cancelled
    const MergeSequence& upTo(double cutoff_m, Progress& progress);

    MergeSequence release() &&;

  private:
    Linkage linkage_;
    MergeSequence sequence_;
    std::size_t samePlaceMerges_ = 0;
    /// Single linkage: the places. Centroid linkage: the clusters that are left.
    std::vector<LivingCluster> clusters_;
};

/// The clusters at a cutoff: those at the first merge beyond it. This is the definition of scipy's
/// `fcluster(linkage(X, method), cutoff, 'distance')`, for centroid linkage too, although its merges are not monotone
/// (a merged centroid can be closer to a third cluster than the merged two were to each other): fcluster joins a node's
/// points when no merge below it, the node included, is beyond the cutoff. All merges before the stop are within it, so
/// the clusters at the stop are joined. No later merge joins more: at the stop all living pairs are beyond the cutoff,
/// and a merge of two of those clusters keeps its distance; any other merge within the cutoff involves a cluster made
/// after the stop, and by induction every such cluster has a merge beyond the cutoff below it.
/// @return a label per point; labels are numbered from 0 by each cluster's first point
/// @throws Error when the cutoff is negative, not finite or beyond the largest of the sequence
std::vector<std::uint32_t> clustersAt(const MergeSequence& sequence, double cutoff_m);

/// mergeSequence() and clustersAt() in one.
std::vector<std::uint32_t> linkageClusters(std::span<const Eigen::Vector3d> points, Linkage linkage, double cutoff_m,
                                           Progress& progress);

}  // namespace fodscope
