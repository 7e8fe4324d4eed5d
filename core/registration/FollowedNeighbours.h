// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/cloud/NeighbourIndex.h"
#include "core/common/Progress.h"

namespace fodscope {

/// The nearest targets of points that move together, little from one call to the next: what an iterative fit asks for.
/// A search also tells how much farther the second nearest target is; until the point has moved by half of that, the
/// nearest one remains the same and nothing is searched. So the answers are those of NeighbourIndex, at a fraction of
/// its time. Source: the triangle inequality, as Elkan 2003 uses it for k-means.
class FollowedNeighbours {
  public:
    /// @param targets the points that `index` searches; both must outlive this
    FollowedNeighbours(const NeighbourIndex& index, std::span<const Eigen::Vector3d> targets)
        : index_(index), targets_(targets) {}

    /// @param queries the same points every time, moved; as many as in the first call
    /// @return the nearest target of each, valid until the next call; the same for any number of threads
    std::span<const Neighbour> nearestOf(std::span<const Eigen::Vector3d> queries, Progress& progress);

  private:
    /// What the last search of a point found out.
    struct Known {
        Eigen::Vector3d place = Eigen::Vector3d::Zero();
        /// Squared; within it the nearest target stays the nearest. Nowhere before the first search.
        double slack_m2 = -1.0;
    };

    std::vector<std::uint32_t> followed(std::span<const Eigen::Vector3d> queries);
    void search(std::span<const Eigen::Vector3d> queries, std::span<const std::uint32_t> lost, Progress& progress);

    const NeighbourIndex& index_;
    std::span<const Eigen::Vector3d> targets_;
    std::vector<Known> known_;
    std::vector<Neighbour> nearest_;
};

}  // namespace fodscope
