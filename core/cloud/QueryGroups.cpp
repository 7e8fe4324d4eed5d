// SPDX-License-Identifier: MIT
#include "core/cloud/QueryGroups.h"

#include <algorithm>

namespace fodscope {
namespace {

/// Few enough to be spread over threads, many enough to keep neighbours together.
constexpr std::size_t kMostInRun = 2048;

/// Looks at a few points only: if the others differ, the tree's order is one in which to ask, but not the best.
bool seemToBePointsOf(const BlockTree& tree, std::span<const Eigen::Vector3d> queries) {
    constexpr std::size_t looks = 16;
    if (queries.size() != tree.size()) return false;
    PointBlock room;
    for (std::size_t look = 0; look < looks; ++look) {
        const PointBlock& block = tree.firstBlock(tree.runCount() * look / looks, room);
        if (queries[block.original[0]] != block.point(0)) return false;
    }
    return true;
}

}  // namespace

void QueryGroup::add(const Eigen::Vector3d& query, std::uint32_t index) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        queries.at[axis][count] = query[static_cast<Eigen::Index>(axis)];
    queries.original[count++] = index;
    round.add(query);
}

void QueryGroup::fillUp() {
    for (std::size_t i = count; i < kBlockSize; ++i) {
        for (std::array<double, kBlockSize>& coordinates : queries.at)
            coordinates[i] = coordinates[count - 1];
        queries.original[i] = queries.original[count - 1];
    }
}

QueryGroups::QueryGroups(std::span<const Eigen::Vector3d> queries, const BlockTree& tree, const Progress& progress)
    : queries_(queries), tree_(tree), areOwn_(seemToBePointsOf(tree, queries)) {
    if (!areOwn_) runs_ = spatialRuns(queries, kMostInRun, progress);
}

QueryGroup QueryGroups::grouped(std::span<const std::uint32_t> indices) const {
    QueryGroup group;
    for (const std::uint32_t index : indices)
        group.add(queries_[index], index);
    group.fillUp();
    return group;
}

QueryGroup QueryGroups::grouped(std::span<const PlacedPoint> points) {
    QueryGroup group;
    for (const PlacedPoint& point : points)
        group.add(Eigen::Vector3d(point.at.data()), point.index);
    group.fillUp();
    return group;
}

std::vector<PlacedPoint> QueryGroups::inBlocks(std::span<const std::uint32_t> indices) const {
    std::vector<PlacedPoint> placed = placedPoints(queries_, indices);
    orderInBlocks(placed);
    return placed;
}

}  // namespace fodscope
