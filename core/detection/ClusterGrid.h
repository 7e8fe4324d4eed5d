// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/detection/SquaredDistance.h"

namespace fodscope {

/// The floor of a number within the range of the result: quicker than the one for all numbers.
inline std::int64_t wholeBelow(double value) {
    const auto towardsZero = static_cast<std::int64_t>(value);
    return towardsZero - (static_cast<double>(towardsZero) > value ? 1 : 0);
}

/// A cluster that may still be merged.
struct LivingCluster {
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
    std::uint32_t id = 0;
    /// The points that it is made of.
    std::uint32_t count = 1;
};

/// Clusters in a grid whose cells are as wide as the farthest distance that is asked for, so that neighbours lie in the
/// same cell or one next to it. Cells are found by hashing; cells that share a place in the table cost time, never a
/// neighbour. Clusters are known by their slots, which follow the cells: what is near in space is mostly near in
/// memory.
class ClusterGrid {
  public:
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

    struct Found {
        double squaredDistance = 0.0;
        std::uint32_t slot = kNone;
    };

    /// @param reach_m nearestOther() finds all clusters within this, and may find ones a little farther
    ClusterGrid(const std::vector<LivingCluster>& clusters, double reach_m);

    std::uint32_t size() const { return static_cast<std::uint32_t>(nodes_.size()); }
    std::uint32_t id(std::uint32_t slot) const { return nodes_[slot].id; }
    /// Changes when the cluster is merged, whether it stays or goes.
    std::uint32_t version(std::uint32_t slot) const { return versions_[slot]; }

    const Eigen::Vector3d& centroid(std::uint32_t slot) const { return nodes_[slot].centroid; }
    std::uint32_t count(std::uint32_t slot) const { return nodes_[slot].count; }
    /// At least the reach.
    double cell_m() const { return cell_m_; }

    /// @return the nearest other cluster at most that far away, of several at the same distance the one with the least
    ///         id; no slot when there is none
    Found nearestOther(std::uint32_t slot, double largestSquaredDistance) const;
    /// Of those whose flag, one a slot, is set.
    Found nearestFlagged(std::uint32_t slot, double largestSquaredDistance,
                         const std::vector<std::uint8_t>& flags) const;

    /// The cluster with the lower id stays, moved to the centroid of both.
    /// @return its slot
    std::uint32_t merge(std::uint32_t slot, std::uint32_t other);

    /// @return what lives, in no particular order; the grid is empty then
    std::vector<LivingCluster> release();

  private:
    struct Node {
        Eigen::Vector3d centroid;
        std::uint32_t id;
        /// 0: it was merged into another one.
        std::uint32_t count;
        std::uint32_t next;
        std::uint32_t bucket;
    };

    std::uint64_t hash(std::int64_t x, std::int64_t y, std::int64_t z) const;
    std::uint32_t bucketOf(const Eigen::Vector3d& point) const;
    template <typename Accept>
    Found nearest(std::uint32_t slot, double largestSquaredDistance, const Accept& accept) const;
    void link(std::uint32_t slot, std::uint32_t bucket);
    void unlink(std::uint32_t slot);

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> versions_;
    std::vector<std::uint32_t> heads_;
    std::uint64_t mask_ = 0;
    double cell_m_ = 1.0;
    double cellsPerMetre_ = 1.0;
};

}  // namespace fodscope
