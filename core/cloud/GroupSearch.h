// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "core/cloud/BlockTree.h"
#include "core/cloud/KNearest.h"
#include "core/cloud/QueryGroups.h"

namespace fodscope {

/// Calls `meet(block, bits)` for every block that may hold a point within reach of a query of the group, with the bits
/// of these queries; it returns whether a reach became shorter.
template <class Meet>
void meetBlocks(const BlockTree& tree, const QueryGroup& group, const BlockDistances& reaches, const Meet& meet) {
    double reach = *std::ranges::max_element(reaches);
    PointBlock room;
    tree.visit(
        group.round, [&] { return reach; },
        [&](std::uint32_t number) {
            const std::uint32_t near = tree.kernels().nearBox(tree.boxOf(number), group.queries, reaches);
            if (near == 0) return;
            if (meet(tree.block(number, room), near)) reach = *std::ranges::max_element(reaches);
        });
}

/// The one nearest point of each query of a group.
class NearestOfGroup {
  public:
    NearestOfGroup(const BlockTree& tree, const QueryGroup& group);
    Neighbour operator[](std::size_t query) const { return {index_[query], squaredDistance_m2_[query]}; }

  private:
    void take(std::size_t query, const Neighbour& neighbour);
    bool meet(const BlockKernels& kernels, const PointBlock& block, const PointBlock& queries, std::uint32_t near);

    BlockDistances squaredDistance_m2_;
    std::array<std::uint32_t, kBlockSize> index_;
};

/// The k nearest points of each query of one group after the other. The groups of a run lie together: how far the k-th
/// is from one tells how far to look from the next.
class KNearestOfGroups {
  public:
    KNearestOfGroups(const BlockTree& tree, std::size_t k) : tree_(tree), k_(k) {}

    /// Calls `use(index, neighbours)` for each query, with its index and the k nearest, nearest first.
    template <class Use>
    void search(const QueryGroup& group, const Use& use) {
        // Not every query's k-th is as far as that of the farthest of the group before.
        constexpr double longer = 1.35;
        gather(group);
        double farthest_m2 = 0.0;
        for (std::size_t i = 0; i < group.count; ++i) {
            const std::span<const Neighbour> sorted = nearest_[i].sorted(tree_.kernels());
            farthest_m2 = std::max(farthest_m2, sorted.back().squaredDistance_m2);
            use(group.queries.original[i], sorted);
        }
        guess_m2_ = std::min(longer * farthest_m2, kAnywhere_m2);
    }

  private:
    void gather(const QueryGroup& group);
    void meetAll(const QueryGroup& group, BlockDistances& reaches);

    const BlockTree& tree_;
    std::size_t k_;
    double guess_m2_ = kAnywhere_m2;
    std::array<KNearest, kBlockSize> nearest_;
};

}  // namespace fodscope
