// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/cloud/NeighbourIndex.h"
#include "core/common/Progress.h"

namespace fodscope {

/// Points with the links of each to its nearest others, for searches that know about where the nearest point is: the
/// same points moved a little, as an iterative fit asks for them, or a point beside the last one. From there the search
/// walks along the links to ever nearer points. Where it ends, by the triangle inequality no other point can be nearer
/// if the query lies within half the length of the longest link; if not, the whole index is searched. So the answers
/// are those of NeighbourIndex, for a fraction of its time.
class NeighbourGraph {
  public:
    /// Nearest points that each point is linked to; fewer points are all linked.
    static constexpr std::size_t kLinks = 12;

    /// @param points must outlive this
    /// @throws Error when there are no points, or one is not finite
    NeighbourGraph(std::span<const Eigen::Vector3d> points, Progress& progress);

    std::span<const Eigen::Vector3d> points() const { return points_; }
    const NeighbourIndex& index() const { return index_; }
    /// @return the points that a point is linked to, the nearest first
    std::span<const std::uint32_t> linksOf(std::size_t point) const {
        return std::span(links_[point].to).first(std::min(kLinks, points_.size() - 1));
    }

    /// @param hint a point, best one near the query
    Neighbour nearest(const Eigen::Vector3d& query, std::uint32_t hint) const;

    /// The nearest point of each query, in parallel; the same for any number of threads.
    /// @param nearest what was found for these queries when they lay elsewhere, and becomes what is found now; where it
    ///        has not as many, they are searched from each other
    void update(std::span<const Eigen::Vector3d> queries, std::vector<Neighbour>& nearest, Progress& progress) const;

  private:
    struct Links {
        std::array<std::uint32_t, kLinks> to{};
        /// A query nearer than this to the point is not nearer to what a link leads to, nor to what the links after it
        /// lead to: half the link's length, squared, rounded down. Beyond the last link lies everything else.
        std::array<float, kLinks> halfLength_m2{};
    };

    std::span<const Eigen::Vector3d> points_;
    NeighbourIndex index_;
    std::vector<Links> links_;
};

}  // namespace fodscope
