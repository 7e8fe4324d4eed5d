// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/cloud/BlockKernels.h"
#include "core/common/Progress.h"

namespace fodscope {

/// Points in compact blocks of 16, a box round each block, round each 8 of these boxes, and so on up to one group of
/// boxes. Searched with whole blocks and whole groups of boxes at a time. Takes 20 bytes a point where all coordinates
/// are float32, as they are in files, and else 32; and 4 more while it is made.
///
/// Blocks are made run by run (see SpatialRuns.h), so that all sorting but the first happens in the cache. Each run has
/// the numbers of 512 blocks to itself, and those that it does not need stay unused.
///
/// A distance to a box is computed with the same operations in the same order as a distance to a point. As rounding is
/// monotone, the box's is never greater than that of a point in it, and the search is exact without any margin.
class BlockTree {
  public:
    /// All points must be finite, and there must be one.
    /// @throws Cancelled
    BlockTree(std::span<const Eigen::Vector3d> points, const BlockKernels& kernels, const Progress& progress);

    std::size_t size() const { return size_; }
    const BlockKernels& kernels() const { return *kernels_; }

    /// Visits the blocks that may hold a point within `reach()` (a squared distance) of the box, the nearest boxes
    /// first. `reach` may shrink while blocks are visited.
    template <class Reach, class Visit>
    void visit(const PointBox& queries, const Reach& reach, const Visit& visitBlock) const;

    /// The block's box.
    PointBox boxOf(std::uint32_t block) const;

    /// The block itself, or what becomes of `room`.
    const PointBlock& block(std::uint32_t number, PointBlock& room) const {
        const std::size_t place = placeOf(number);
        if (!small_) return wide_[place];
        kernels_->widen(small_[place], room);
        return room;
    }

    /// The first block of a run.
    const PointBlock& firstBlock(std::size_t run, PointBlock& room) const {
        return block(static_cast<std::uint32_t>(run * kBlocksInRun), room);
    }

    /// Runs of blocks that lie together; every point is in one of them.
    std::size_t runCount() const { return firstPlaces_.size() - 1; }
    std::size_t blocksIn(std::size_t run) const { return firstPlaces_[run + 1] - firstPlaces_[run]; }
    /// Indices of the points in a run's block.
    std::span<const std::uint32_t> originals(std::size_t run, std::size_t block) const;

  private:
    struct Found {
        double squaredDistance;
        std::uint32_t level;
        std::uint32_t index;
    };

    static constexpr std::size_t kBlocksInRun = kBlockFan * kBlockFan * kBlockFan;

    std::size_t placeOf(std::uint32_t number) const {
        return firstPlaces_[number / kBlocksInRun] + number % kBlocksInRun;
    }
    PointBox write(std::span<const PlacedPoint> points, std::size_t place);
    void makeRun(std::span<const Eigen::Vector3d> points, std::span<const std::uint32_t> indices, std::size_t run);
    void makeUpperLevels();

    const BlockKernels* kernels_;
    std::size_t size_ = 0;
    /// Where each run's blocks begin, and where the last one's end.
    std::vector<std::uint32_t> firstPlaces_;
    /// One of the two.
    std::unique_ptr<PointBlock[]> wide_;
    std::unique_ptr<SmallBlock[]> small_;
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
        kernels_->boxDistances(levels_[level][next.index], queries, distances);
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
