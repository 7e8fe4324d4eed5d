// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "core/common/Progress.h"
#include "core/detection/ClusterGrid.h"
#include "core/detection/HierarchicalClustering.h"

namespace fodscope {

/// From the cutoff of a round to the next.
inline constexpr double kRoundStep = 1.5;

/// @param denser how many times as many there are, if these are a sample
/// @return the cutoff of the first round, at most `largest_m`
double firstReach(const std::vector<LivingCluster>& clusters, double largest_m, double denser = 1.0);

/// Centroid linkage as far as it has come: its clusters, and what it takes to go on to a greater cutoff; see
/// mergeSequence().
///
/// It goes up to its cutoff in rounds, each with a cutoff half as great again as that of the round before. That changes
/// nothing: which pair is merged next depends on the living clusters alone, and a round ends where no pair is within
/// its cutoff, which is where the whole agglomeration comes by too, before its first merge beyond. But all that live in
/// a round are farther apart than the cutoff of the round before, so that few of them share a cell of a grid as wide as
/// the reach.
class CentroidAgglomeration {
  public:
    /// @param clusters no two at the same place, of different ids
    explicit CentroidAgglomeration(std::vector<LivingCluster> clusters) : living_(std::move(clusters)) {}

    /// Appends the merges up to a cutoff, in order. When it throws, the agglomeration is of no more use.
    void advance(double cutoff_m, std::vector<Merge>& merges, Progress& progress);

    /// @return the clusters that are left
    std::vector<LivingCluster> release() { return std::move(living_); }

  private:
    std::vector<LivingCluster> living_;
};

}  // namespace fodscope
