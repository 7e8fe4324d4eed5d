// SPDX-License-Identifier: MIT
#include "core/detection/ClusterGrid.h"

#include <algorithm>
#include <array>
#include <bit>

namespace fodscope {
namespace {

/// Cells along x lie side by side in the table; the other directions are scattered over it.
constexpr std::uint64_t kRowStep = 0x9E3779B97F4A7C15u;
constexpr std::uint64_t kLayerStep = 0xC2B2AE3D27D4EB4Fu;

/// A coordinate in cells is at most 2^40 and so known to 2^-12 of a cell. Cells are wider than the reach by more than
/// what that may hide, and walls of cells count as nearer by more.
constexpr double kMostCells = 1099511627776.0;
constexpr double kWider = 1.002;
constexpr double kSlack = 1e-3;

double largestCoordinate(const std::vector<LivingCluster>& clusters) {
    double largest = 0.0;
    for (const LivingCluster& cluster : clusters)
        largest = std::max(largest, cluster.centroid.cwiseAbs().maxCoeff());
    return largest;
}

double squared(double value) {
    return value * value;
}

}  // namespace

ClusterGrid::ClusterGrid(const std::vector<LivingCluster>& clusters, double reach_m) {
    cell_m_ = std::clamp(kWider * reach_m, largestCoordinate(clusters) / kMostCells, 1e300);
    cell_m_ = std::max(cell_m_, std::numeric_limits<double>::min());
    cellsPerMetre_ = 1.0 / cell_m_;
    const std::size_t buckets = std::bit_ceil(std::max<std::size_t>(16, 2 * clusters.size()));
    mask_ = buckets - 1;
    heads_.assign(buckets, 0);
    versions_.resize(clusters.size(), 0);
    std::vector<std::uint32_t> bucket(clusters.size());
    for (std::size_t i = 0; i < clusters.size(); ++i) {
        bucket[i] = bucketOf(clusters[i].centroid);
        ++heads_[bucket[i]];
    }
    std::uint32_t first = 0;
    for (std::uint32_t& head : heads_) {
        first += head;
        head = first - head;
    }
    nodes_.resize(clusters.size());
    for (std::size_t i = 0; i < clusters.size(); ++i) {
        const std::uint32_t slot = heads_[bucket[i]]++;
        nodes_[slot] = {clusters[i].centroid, clusters[i].id, clusters[i].count, slot + 1, bucket[i]};
    }
    // Each head is now where the next bucket's clusters begin.
    for (std::size_t b = buckets; b-- > 0;) {
        const std::uint32_t begin = b == 0 ? 0 : heads_[b - 1];
        const std::uint32_t end = heads_[b];
        heads_[b] = begin == end ? kNone : begin;
        if (begin != end) nodes_[end - 1].next = kNone;
    }
}

std::uint64_t ClusterGrid::hash(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return static_cast<std::uint64_t>(x) + (static_cast<std::uint64_t>(y) * kRowStep >> 20) +
           (static_cast<std::uint64_t>(z) * kLayerStep >> 20);
}

std::uint32_t ClusterGrid::bucketOf(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d at = point * cellsPerMetre_;
    return static_cast<std::uint32_t>(hash(wholeBelow(at.x()), wholeBelow(at.y()), wholeBelow(at.z())) & mask_);
}

template <typename Accept>
ClusterGrid::Found ClusterGrid::nearest(std::uint32_t slot, double largestSquaredDistance, const Accept& accept) const {
    const Eigen::Vector3d at = nodes_[slot].centroid * cellsPerMetre_;
    const std::array<std::int64_t, 3> cell{wholeBelow(at.x()), wholeBelow(at.y()), wholeBelow(at.z())};
    /// Squared distance to the walls of the own cell, before and behind in each direction.
    std::array<std::array<double, 2>, 3> wall;
    for (int axis = 0; axis < 3; ++axis) {
        const double within = at[axis] - static_cast<double>(cell[axis]);
        wall[axis] = {squared(std::max(0.0, within - kSlack) * cell_m_),
                      squared(std::max(0.0, 1.0 - within - kSlack) * cell_m_)};
    }
    Found best{largestSquaredDistance, kNone};
    std::uint32_t bestId = kNone;
    const auto scan = [&](std::uint64_t hash) {
        for (std::uint32_t other = heads_[hash & mask_]; other != kNone; other = nodes_[other].next) {
            const Node& node = nodes_[other];
            const double distance = squaredDistance(nodes_[slot].centroid, node.centroid);
            if (distance > best.squaredDistance || other == slot || !accept(other)) continue;
            if (distance == best.squaredDistance && node.id >= bestId) continue;
            best = {distance, other};
            bestId = node.id;
        }
    };
    const auto row = [&](std::int64_t y, std::int64_t z, double distance) {
        if (distance > best.squaredDistance) return;
        const std::uint64_t middle = hash(cell[0], cell[1] + y, cell[2] + z);
        scan(middle);
        if (distance + wall[0][0] <= best.squaredDistance) scan(middle - 1);
        if (distance + wall[0][1] <= best.squaredDistance) scan(middle + 1);
    };
    row(0, 0, 0.0);
    const std::int64_t nearY = wall[1][0] <= wall[1][1] ? -1 : 1;
    const std::int64_t nearZ = wall[2][0] <= wall[2][1] ? -1 : 1;
    const auto [nearWallY, farWallY] = std::minmax(wall[1][0], wall[1][1]);
    const auto [nearWallZ, farWallZ] = std::minmax(wall[2][0], wall[2][1]);
    row(nearY, 0, nearWallY);
    row(0, nearZ, nearWallZ);
    row(nearY, nearZ, nearWallY + nearWallZ);
    row(-nearY, 0, farWallY);
    row(0, -nearZ, farWallZ);
    row(-nearY, nearZ, farWallY + nearWallZ);
    row(nearY, -nearZ, nearWallY + farWallZ);
    row(-nearY, -nearZ, farWallY + farWallZ);
    return best;
}

ClusterGrid::Found ClusterGrid::nearestOther(std::uint32_t slot, double largestSquaredDistance) const {
    return nearest(slot, largestSquaredDistance, [](std::uint32_t) { return true; });
}

ClusterGrid::Found ClusterGrid::nearestFlagged(std::uint32_t slot, double largestSquaredDistance,
                                               const std::vector<std::uint8_t>& flags) const {
    return nearest(slot, largestSquaredDistance, [&](std::uint32_t other) { return flags[other] != 0; });
}

void ClusterGrid::link(std::uint32_t slot, std::uint32_t bucket) {
    nodes_[slot].bucket = bucket;
    nodes_[slot].next = heads_[bucket];
    heads_[bucket] = slot;
}

void ClusterGrid::unlink(std::uint32_t slot) {
    std::uint32_t* link = &heads_[nodes_[slot].bucket];
    while (*link != slot)
        link = &nodes_[*link].next;
    *link = nodes_[slot].next;
}

std::uint32_t ClusterGrid::merge(std::uint32_t slot, std::uint32_t other) {
    const std::uint32_t kept = nodes_[slot].id < nodes_[other].id ? slot : other;
    const std::uint32_t removed = kept == slot ? other : slot;
    Node& stays = nodes_[kept];
    Node& goes = nodes_[removed];
    unlink(removed);
    const double count = static_cast<double>(stays.count) + static_cast<double>(goes.count);
    const Eigen::Vector3d step = goes.centroid - stays.centroid;
    stays.centroid += step * (static_cast<double>(goes.count) / count);
    stays.count += goes.count;
    goes.count = 0;
    ++versions_[kept];
    ++versions_[removed];
    const std::uint32_t bucket = bucketOf(stays.centroid);
    if (bucket != stays.bucket) {
        unlink(kept);
        link(kept, bucket);
    }
    return kept;
}

std::vector<LivingCluster> ClusterGrid::release() {
    heads_ = {};
    std::vector<LivingCluster> living;
    for (const Node& node : nodes_)
        if (node.count > 0) living.push_back({node.centroid, node.id, node.count});
    nodes_ = {};
    return living;
}

}  // namespace fodscope
