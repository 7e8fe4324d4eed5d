// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/common/Progress.h"

namespace fodscope {

class BlockTree;
struct BlockKernels;

struct Neighbour {
    std::uint32_t index = 0;
    double squaredDistance_m2 = 0.0;
};

/// The one nearest-neighbour search that everything uses: exact, in double precision, over compact blocks of points
/// (see BlockTree.h). It keeps its own copy of the points. Answers do not depend on the number of threads; of points at
/// the same distance the one with the lower index comes first.
///
/// The functions that take a Progress look at it often enough to be cancelled at once; with a stage name they also
/// report their fraction under that name.
class NeighbourIndex {
  public:
    /// @throws Error when there are no points, or one is not finite
    explicit NeighbourIndex(std::span<const Eigen::Vector3d> points);
    /// @throws Cancelled
    NeighbourIndex(std::span<const Eigen::Vector3d> points, const Progress& progress);
    /// With inner loops that are not the fastest of this processor: all must give the same.
    NeighbourIndex(std::span<const Eigen::Vector3d> points, const Progress& progress, const BlockKernels& kernels);
    ~NeighbourIndex();
    NeighbourIndex(NeighbourIndex&&) noexcept;
    NeighbourIndex& operator=(NeighbourIndex&&) noexcept;

    std::size_t size() const;

    Neighbour nearest(const Eigen::Vector3d& query) const;

    /// @return the min(k, size()) nearest points, nearest first; a query that is a point of the index finds itself
    std::vector<Neighbour> kNearest(const Eigen::Vector3d& query, std::size_t k) const;

    /// @return the points at most `radius_m` away, nearest first
    std::vector<Neighbour> withinRadius(const Eigen::Vector3d& query, double radius_m) const;

    /// The nearest point of each query, in parallel.
    std::vector<Neighbour> nearestOfEach(std::span<const Eigen::Vector3d> queries, Progress& progress,
                                         const std::string& stage = {}) const;

    /// Calls `use(i, neighbours)` once for every query, in parallel and in any order, with the k nearest points. When
    /// the queries are the index's own points, in their order, they need not be sorted.
    void forEachKNearest(std::span<const Eigen::Vector3d> queries, std::size_t k,
                         const std::function<void(std::size_t, std::span<const Neighbour>)>& use, Progress& progress,
                         const std::string& stage = {}) const;

    /// The same with the points at most `radius_m` away, which may be none. Their order is not by distance, as sorting
    /// would cost more than the search, but it is the same every time.
    void forEachWithinRadius(std::span<const Eigen::Vector3d> queries, double radius_m,
                             const std::function<void(std::size_t, std::span<const Neighbour>)>& use,
                             Progress& progress, const std::string& stage = {}) const;

  private:
    std::unique_ptr<BlockTree> tree_;
};

}  // namespace fodscope
