// SPDX-License-Identifier: MIT
#include "core/cloud/BlockTree.h"

#include <algorithm>

#include "core/cloud/BlockOrder.h"

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

std::vector<BoxGroup> grouped(std::span<const PointBox> boxes) {
    std::vector<BoxGroup> groups((boxes.size() + kBlockFan - 1) / kBlockFan, noBoxes());
    for (std::size_t i = 0; i < boxes.size(); ++i)
        put(groups[i / kBlockFan], i % kBlockFan, boxes[i]);
    return groups;
}

}  // namespace

BlockTree::BlockTree(std::span<const Eigen::Vector3d> points) : size_(points.size()) {
    const std::vector<std::uint32_t> order = blockOrder(points);
    blocks_.resize((points.size() + kBlockSize - 1) / kBlockSize);
    std::vector<PointBox> boxes(blocks_.size());
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        PointBlock& block = blocks_[b];
        for (std::size_t i = 0; i < kBlockSize; ++i) {
            const std::size_t place = b * kBlockSize + i;
            const bool isThere = place < order.size();
            if (isThere) boxes[b].add(points[order[place]]);
            block.original[i] = isThere ? order[place] : std::numeric_limits<std::uint32_t>::max();
            for (std::size_t axis = 0; axis < 3; ++axis)
                block.at[axis][i] = isThere ? points[order[place]][static_cast<Eigen::Index>(axis)] : kInfinity;
        }
    }
    levels_.push_back(grouped(boxes));
    while (levels_.back().size() > 1) {
        boxes.resize(levels_.back().size());
        std::ranges::transform(levels_.back(), boxes.begin(), boxRound);
        levels_.push_back(grouped(boxes));
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

}  // namespace fodscope
