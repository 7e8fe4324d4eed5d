// SPDX-License-Identifier: MIT
#include "core/cloud/GroupSearch.h"

namespace fodscope {

NearestOfGroup::NearestOfGroup(const BlockTree& tree, const QueryGroup& group) {
    squaredDistance_m2_.fill(kAnywhere_m2);
    index_.fill(kNowhere);
    meetBlocks(tree, group, squaredDistance_m2_, [&](const PointBlock& block, std::uint32_t near) {
        return meet(tree.kernels(), block, group.queries, near);
    });
    for (std::size_t i = 0; i < kBlockSize; ++i)
        if (index_[i] == kNowhere) take(i, kInfinitelyFar);
}

bool NearestOfGroup::meet(const BlockKernels& kernels, const PointBlock& block, const PointBlock& queries,
                          std::uint32_t near) {
    BlockDistances least;
    const std::uint32_t nearer = kernels.leastDistances(block, queries, near, squaredDistance_m2_, least);
    forEachBit(nearer, [&](std::size_t query) {
        BlockDistances distances;
        const std::uint32_t atLeast = kernels.squaredDistances(block, queries.point(query), least[query], distances);
        std::uint32_t index = kNowhere;
        forEachBit(atLeast, [&](std::size_t i) { index = std::min(index, block.original[i]); });
        if (least[query] == squaredDistance_m2_[query]) index = std::min(index, index_[query]);
        take(query, {index, least[query]});
    });
    return nearer != 0;
}

void NearestOfGroup::take(std::size_t query, const Neighbour& neighbour) {
    index_[query] = neighbour.index;
    squaredDistance_m2_[query] = neighbour.squaredDistance_m2;
}

void KNearestOfGroups::gather(const QueryGroup& group) {
    // Looking for those again for which a guess was too short costs less than beginning without one.
    constexpr double muchLonger = 4.0;
    std::uint32_t wanted = (1U << group.count) - 1;
    for (const double reach_m2 : {guess_m2_, std::min(muchLonger * guess_m2_, kAnywhere_m2), kAnywhere_m2}) {
        BlockDistances reaches;
        reaches.fill(-1.0);
        forEachBit(wanted, [&](std::size_t i) {
            nearest_[i].start(k_, reach_m2);
            reaches[i] = reach_m2;
        });
        meetAll(group, reaches);
        forEachBit(wanted, [&](std::size_t i) { wanted ^= nearest_[i].hasEnough() ? 1U << i : 0U; });
        if (wanted == 0) return;
    }
}

void KNearestOfGroups::meetAll(const QueryGroup& group, BlockDistances& reaches) {
    meetBlocks(tree_, group, reaches, [&](const PointBlock& block, std::uint32_t near) {
        bool isShorter = false;
        forEachBit(near, [&](std::size_t i) {
            if (!nearest_[i].add(tree_.kernels(), block, group.queries.point(i))) return;
            reaches[i] = nearest_[i].reach();
            isShorter = true;
        });
        return isShorter;
    });
}

}  // namespace fodscope
