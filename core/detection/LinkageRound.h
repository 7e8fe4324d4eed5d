// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/common/Progress.h"
#include "core/detection/ClusterGrid.h"

namespace fodscope {

/// A merge as a round remembers it.
struct RoundMerge {
    std::uint32_t kept = 0;
    std::uint32_t removed = 0;
    double squaredDistance = 0.0;
};

/// What a round of centroid linkage began with, and its merges in order.
struct RoundRecord {
    std::vector<LivingCluster> start;
    std::vector<RoundMerge> merges;
};

/// How far an agglomeration is when a round begins, for its progress.
struct LinkageProgress {
    Progress& progress;
    std::size_t merges = 0;
    std::size_t points = 1;

    void report(std::size_t more) const {
        progress.report("clustering", static_cast<double>(merges + more) / static_cast<double>(points));
    }
};

/// A round: of all pairs of clusters the closest becomes one, over and over, until no pair is within the limit.
/// @param[in,out] clusters no two at the same place, of different ids; what is left of them
/// @param reach_m at least the root of the limit; a grid as wide should have few clusters in a cell
std::vector<RoundMerge> runRound(std::vector<LivingCluster>& clusters, double reach_m, double largestSquaredDistance,
                                 const LinkageProgress& progress);

/// The same round, of which one with mostly the same clusters is remembered: only what came of the others is merged
/// anew.
///
/// A cluster is old as long as the remembered round had it at that point too, made of the same. Of two old clusters
/// nothing new can be learned: the next remembered merge was the closest of all pairs that lived then, and the old
/// clusters are some of those. If it is between two old clusters, it is the closest pair of old ones now. If one of its
/// clusters is not there any more, it does not happen; the other, if it is there, has from now on a fate of its own and
/// counts as new. Each pair with a new cluster is in the queue as in a round without memory, where of every two
/// clusters the one that came later has looked at the other: new ones look at all, old ones that are made by a
/// remembered merge look at the new ones. So whichever goes first, the next remembered merge or the head of the queue,
/// is the closest of all pairs.
/// @param before a round with the same limit
/// @param slotOfId scratch space with a place for every id
std::vector<RoundMerge> replayRound(const RoundRecord& before, std::vector<LivingCluster>& clusters, double reach_m,
                                    double largestSquaredDistance, std::vector<std::uint32_t>& slotOfId,
                                    const LinkageProgress& progress);

}  // namespace fodscope
