// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/cloud/BlockTree.h"
#include "core/cloud/SpatialRuns.h"

namespace fodscope {

/// Up to 16 queries that lie near each other and go through the tree together.
struct QueryGroup {
    /// Where there are fewer than 16, the last one again.
    PointBlock queries;
    std::size_t count = 0;
    PointBox round;

    void add(const Eigen::Vector3d& query, std::uint32_t index);
    void fillUp();
};

/// All queries in such groups, and the groups in runs that lie together. Where the queries are the tree's own points,
/// these lie in order already.
class QueryGroups {
  public:
    QueryGroups(std::span<const Eigen::Vector3d> queries, const BlockTree& tree, const Progress& progress);

    std::size_t runCount() const { return areOwn_ ? tree_.runCount() : runs_.count(); }

    /// Calls `use(group)` for every group of a run.
    template <class Use>
    void forEachOf(std::size_t run, const Use& use) const {
        if (areOwn_) {
            for (std::size_t block = 0; block < tree_.blocksIn(run); ++block)
                use(grouped(tree_.originals(run, block)));
            return;
        }
        const std::vector<PlacedPoint> placed = inBlocks(runs_.run(run));
        for (std::size_t first = 0; first < placed.size(); first += kBlockSize)
            use(grouped(std::span(placed).subspan(first, std::min(kBlockSize, placed.size() - first))));
    }

  private:
    QueryGroup grouped(std::span<const std::uint32_t> indices) const;
    static QueryGroup grouped(std::span<const PlacedPoint> points);
    std::vector<PlacedPoint> inBlocks(std::span<const std::uint32_t> indices) const;

    std::span<const Eigen::Vector3d> queries_;
    const BlockTree& tree_;
    bool areOwn_;
    SpatialRuns runs_;
};

}  // namespace fodscope
