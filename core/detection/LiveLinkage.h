// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/common/Progress.h"
#include "core/detection/LinkageRound.h"

namespace fodscope {

/// Centroid linkage of sets of points that are mostly the same from one time to the next, as when a threshold is moved:
/// each round is remembered, and the next time only what came of other clusters is merged anew. Takes about 150 bytes a
/// point.
class LiveLinkage {
  public:
    /// @param all the points that the sets are of; their ids are 0, 1, …
    explicit LiveLinkage(std::span<const Eigen::Vector3d> all);

    /// Begins again with another set.
    /// @param clusters no two at the same place
    void restart(std::vector<LivingCluster> clusters);
    /// Goes on until no pair within the cutoff is left. When it throws, start from nothing.
    void advance(double cutoff_m, Progress& progress);

    /// Calls `act` with the merges of centroid linkage of the set up to the cutoff, in order.
    template <typename Act>
    void forEachMerge(double cutoff_m, const Act& act) const {
        if (!(cutoff_m > 0.0)) return;
        for (std::size_t round = 0; round < done_; ++round)
            for (const RoundMerge& merge : records_[round].merges) {
                if (std::sqrt(merge.squaredDistance) > cutoff_m) return;
                act(merge.kept, merge.removed);
            }
    }

  private:
    double reachOf(std::size_t round) const;

    double firstReach_m_;
    std::vector<LivingCluster> living_;
    std::size_t points_ = 0;
    /// Those that belong to this set come first; after them those of the set before.
    std::vector<RoundRecord> records_;
    std::size_t done_ = 0;
    std::vector<std::uint32_t> slotOfId_;
};

}  // namespace fodscope
