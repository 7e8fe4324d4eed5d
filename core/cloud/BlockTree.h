// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/cloud/BlockKernels.h"

namespace fodscope {

/// Points in compact blocks of 16, a box round each block, round each 8 of these boxes, and so on up to
/// one group of boxes. Made in a sort and one pass; searched with whole blocks and whole groups of boxes at a time.
///
/// A distance to a box is computed with the same operations in the same order as a distance to a point. As rounding is
/// monotone, the box's is never greater than that of a point in it, and the search is exact without any margin.
class BlockTree {
  public:
    /// All points must be finite, and there must be one.
    explicit BlockTree(std::span<const Eigen::Vector3d> points);

    std::size_t size() const { return size_; }

    /// Visits the blocks that may hold a point within `reach()` (a squared distance) of the box, the nearest boxes
    /// first. `reach` may shrink while blocks are visited.
    template <class Reach, class Visit>
    void visit(const PointBox& queries, const Reach& reach, const Visit& visitBlock) const;

    /// The block's box.
    PointBox boxOf(std::uint32_t block) const;

    const PointBlock& block(std::uint32_t index) const { return blocks_[index]; }

  private:
    struct Found {
        double squaredDistance;
        std::uint32_t level;
        std::uint32_t index;
    };

    std::size_t size_ = 0;
    std::vector<PointBlock> blocks_;
    /// levels_[0] holds the boxes of blocks, levels_[n] the boxes round the groups of levels_[n − 1]; the last one is a
    /// single group.
    std::vector<std::vector<BoxGroup>> levels_;
};

template <class Reach, class Visit>
void BlockTree::visit(const PointBox& queries, const Reach& reach, const Visit& visitBlock) const {
    // Each level leaves at most seven siblings behind; 4 billion points have ten levels.
    std::array<Found, 12 * kBlockFan> open;
    std::size_t count = 0;
    open[count++] = {0.0, static_cast<std::uint32_t>(levels_.size()), 0};
    while (count > 0) {
        const Found next = open[--count];
        if (next.squaredDistance > reach()) continue;
        if (next.level == 0) {
            visitBlock(next.index);
            continue;
        }
        const std::uint32_t level = next.level - 1;
        std::array<double, kBlockFan> distances;
        squaredDistances(levels_[level][next.index], queries, distances);
        const double limit = reach();
        const std::size_t first = count;
        for (std::uint32_t child = 0; child < kBlockFan; ++child) {
            const double distance = distances[child];
            if (!(distance <= limit)) continue;
            // The nearest ends on top; of boxes at the same distance the first one.
            std::size_t place = count++;
            for (; place > first && open[place - 1].squaredDistance <= distance; --place)
                open[place] = open[place - 1];
            open[place] = {distance, level, static_cast<std::uint32_t>(next.index * kBlockFan + child)};
        }
    }
}

}  // namespace fodscope
