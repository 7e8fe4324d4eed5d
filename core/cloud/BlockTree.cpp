// SPDX-License-Identifier: MIT
#include "core/cloud/BlockTree.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "core/cloud/SpatialRuns.h"

namespace fodscope {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

BoxGroup noBoxes() {
    BoxGroup boxes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        boxes.low[axis].fill(kInfinity);
        boxes.high[axis].fill(-kInfinity);
    }
    return boxes;
}

PointBox boxRound(const BoxGroup& boxes) {
    PointBox round;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        round.low[static_cast<Eigen::Index>(axis)] = std::ranges::min(boxes.low[axis]);
        round.high[static_cast<Eigen::Index>(axis)] = std::ranges::max(boxes.high[axis]);
    }
    return round;
}

void put(BoxGroup& boxes, std::size_t place, const PointBox& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        boxes.low[axis][place] = box.low[static_cast<Eigen::Index>(axis)];
        boxes.high[axis][place] = box.high[static_cast<Eigen::Index>(axis)];
    }
}

std::size_t partsOf(std::size_t count, std::size_t size) {
    return (count + size - 1) / size;
}

bool areFloats(std::span<const Eigen::Vector3d> points) {
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, points.size(), 1 << 14), true,
        [&](const auto& part, bool are) {
            for (std::size_t i = part.begin(); are && i < part.end(); ++i)
                are = points[i].cwiseAbs().maxCoeff() <= double{std::numeric_limits<float>::max()} &&
                      points[i].cast<float>().cast<double>() == points[i];
            return are;
        },
        std::logical_and<>());
}

template <class Block>
PointBox fill(Block& block, std::span<const PlacedPoint> points) {
    using Coordinate = std::remove_reference_t<decltype(block.at[0][0])>;
    PointBox box;
    for (std::size_t i = 0; i < kBlockSize; ++i) {
        const bool isThere = i < points.size();
        block.original[i] = isThere ? points[i].index : std::numeric_limits<std::uint32_t>::max();
        for (std::size_t axis = 0; axis < 3; ++axis)
            block.at[axis][i] = static_cast<Coordinate>(isThere ? points[i].at[axis] : kInfinity);
        if (isThere) box.add(Eigen::Map<const Eigen::Vector3d>(points[i].at.data()));
    }
    return box;
}

}  // namespace

BlockTree::BlockTree(std::span<const Eigen::Vector3d> points, const BlockKernels& kernels, const Progress& progress)
    : kernels_(&kernels), size_(points.size()) {
    const SpatialRuns runs = spatialRuns(points, kBlocksInRun * kBlockSize, progress);
    firstPlaces_.push_back(0);
    for (std::size_t run = 0; run < runs.count(); ++run) {
        const std::size_t blocks = partsOf(runs.run(run).size(), kBlockSize);
        firstPlaces_.push_back(static_cast<std::uint32_t>(firstPlaces_.back() + blocks));
    }
    // Not cleared: each thread fills its own part, and the system gives the memory then.
    if (areFloats(points)) {
        small_ = std::make_unique_for_overwrite<SmallBlock[]>(firstPlaces_.back());
    } else {
        wide_ = std::make_unique_for_overwrite<PointBlock[]>(firstPlaces_.back());
    }
    const std::size_t numbers = (runs.count() - 1) * kBlocksInRun + blocksIn(runs.count() - 1);
    levels_.emplace_back(partsOf(numbers, kBlockFan), noBoxes());
    tbb::parallel_for(std::size_t{0}, runs.count(), [&](std::size_t run) {
        progress.throwIfCancelled();
        makeRun(points, runs.run(run), run);
    });
    makeUpperLevels();
}

void BlockTree::makeRun(std::span<const Eigen::Vector3d> points, std::span<const std::uint32_t> indices,
                        std::size_t run) {
    std::vector<PlacedPoint> placed = placedPoints(points, indices);
    orderInBlocks(placed);
    for (std::size_t block = 0; block < blocksIn(run); ++block) {
        const std::size_t first = block * kBlockSize;
        const auto of =
            std::span<const PlacedPoint>(placed).subspan(first, std::min(kBlockSize, placed.size() - first));
        const std::size_t place = firstPlaces_[run] + block;
        const PointBox box = small_ ? fill(small_[place], of) : fill(wide_[place], of);
        const std::size_t number = run * kBlocksInRun + block;
        put(levels_.front()[number / kBlockFan], number % kBlockFan, box);
    }
}

void BlockTree::makeUpperLevels() {
    while (levels_.back().size() > 1) {
        const std::vector<BoxGroup>& lower = levels_.back();
        std::vector<BoxGroup> upper(partsOf(lower.size(), kBlockFan), noBoxes());
        for (std::size_t i = 0; i < lower.size(); ++i)
            put(upper[i / kBlockFan], i % kBlockFan, boxRound(lower[i]));
        levels_.push_back(std::move(upper));
    }
}

PointBox BlockTree::boxOf(std::uint32_t block) const {
    const BoxGroup& boxes = levels_.front()[block / kBlockFan];
    PointBox box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        box.low[static_cast<Eigen::Index>(axis)] = boxes.low[axis][block % kBlockFan];
        box.high[static_cast<Eigen::Index>(axis)] = boxes.high[axis][block % kBlockFan];
    }
    return box;
}

std::span<const std::uint32_t> BlockTree::originals(std::size_t run, std::size_t block) const {
    const std::size_t place = firstPlaces_[run] + block;
    const auto& all = small_ ? small_[place].original : wide_[place].original;
    const auto isThere = [](std::uint32_t index) { return index != std::numeric_limits<std::uint32_t>::max(); };
    return std::span(all).first(static_cast<std::size_t>(std::ranges::count_if(all, isThere)));
}

}  // namespace fodscope
