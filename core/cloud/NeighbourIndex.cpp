// SPDX-License-Identifier: MIT
#include "core/cloud/NeighbourIndex.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "core/cloud/BlockOrder.h"
#include "core/cloud/BlockTree.h"
#include "core/cloud/KNearest.h"
#include "core/common/Error.h"

namespace fodscope {
namespace {

/// Queries that lie near each other and go through the tree together.
constexpr std::size_t kGroup = kBlockSize;
/// The one nearest point of a query.
class Nearest {
  public:
    double reach() const { return best_.squaredDistance_m2; }
    void add(const PointBlock& block, std::uint32_t within, const BlockDistances& distances) {
        forEachBit(within, [&](std::size_t i) {
            const Neighbour found{block.original[i], distances[i]};
            if (isNearer(found, best_)) best_ = found;
        });
    }
    const Neighbour& best() const { return best_; }

  private:
    Neighbour best_{std::numeric_limits<std::uint32_t>::max(), kAnywhere_m2};
};

/// All points up to a distance.
class WithinRadius {
  public:
    void start(double squaredRadius_m2) {
        reach_ = squaredRadius_m2;
        found_.clear();
    }
    double reach() const { return reach_; }
    void add(const PointBlock& block, std::uint32_t within, const BlockDistances& distances) {
        forEachBit(within, [&](std::size_t i) { found_.push_back({block.original[i], distances[i]}); });
    }
    /// In the order of the search, which is the same every time.
    std::span<const Neighbour> found() const { return found_; }
    std::span<const Neighbour> sorted() {
        std::sort(found_.begin(), found_.end(), isNearer);
        return found_;
    }

  private:
    double reach_ = 0.0;
    std::vector<Neighbour> found_;
};

double squaredDistance(const PointBox& box, const Eigen::Vector3d& point) {
    const auto gap = [&](int axis) {
        return std::max(std::max(box.low[axis] - point[axis], point[axis] - box.high[axis]), 0.0);
    };
    const double x = gap(0);
    const double y = gap(1);
    const double z = gap(2);
    return x * x + y * y + z * z;
}

/// Lets every collector meet the points within its reach of its query.
template <class Collector>
void search(const BlockTree& tree, std::span<const Eigen::Vector3d> queries, std::span<Collector> collectors) {
    PointBox round;
    for (const Eigen::Vector3d& query : queries)
        round.add(query);
    const auto farthestReach = [&] {
        double reach = 0.0;
        for (const Collector& collector : collectors)
            reach = std::max(reach, collector.reach());
        return reach;
    };
    double reach = farthestReach();
    BlockDistances distances;
    tree.visit(
        round, [&] { return reach; },
        [&](std::uint32_t number) {
            const PointBox box = tree.boxOf(number);
            const PointBlock& block = tree.block(number);
            bool foundAny = false;
            for (std::size_t q = 0; q < queries.size(); ++q) {
                const double limit = collectors[q].reach();
                if (squaredDistance(box, queries[q]) > limit) continue;
                const std::uint32_t within = squaredDistances(block, queries[q], limit, distances);
                if (within == 0) continue;
                collectors[q].add(block, within, distances);
                foundAny = true;
            }
            if (foundAny) reach = farthestReach();
        });
}

template <class Collector>
void search(const BlockTree& tree, const Eigen::Vector3d& query, Collector& collector) {
    search(tree, std::span(&query, 1), std::span(&collector, 1));
}

void check(std::span<const Eigen::Vector3d> points) {
    if (points.empty()) throw Error("point cloud", "it has no points to search among", "give a cloud with points");
    if (points.size() >= std::numeric_limits<std::uint32_t>::max()) {
        throw Error("point cloud", "it has more than 4 billion points", "thin it out first");
    }
    if (!std::ranges::all_of(points, [](const Eigen::Vector3d& p) { return p.allFinite(); })) {
        throw Error("point cloud", "a coordinate is not finite", "drop such points first");
    }
}

/// Calls `use(indices)` for groups of queries that lie near each other, in parallel, until every query had its turn.
/// Only the calling thread reports.
template <class MakeWorker>
void forEachGroup(std::span<const Eigen::Vector3d> queries, Progress& progress, const std::string& stage,
                  const MakeWorker& makeWorker) {
    // Large enough to keep neighbours together, small enough to sort between two looks at the progress.
    constexpr std::size_t sorted = 1 << 20;
    constexpr std::size_t reported = 1 << 14;
    constexpr std::size_t grain = 16;
    for (std::size_t first = 0; first < queries.size(); first += sorted) {
        std::vector<std::uint32_t> order = blockOrder(queries.subspan(first, std::min(sorted, queries.size() - first)));
        for (std::uint32_t& index : order)
            index += static_cast<std::uint32_t>(first);
        for (std::size_t done = 0; done < order.size(); done += reported) {
            if (!stage.empty())
                progress.report(stage, static_cast<double>(first + done) / static_cast<double>(queries.size()));
            const std::span<const std::uint32_t> batch =
                std::span<const std::uint32_t>(order).subspan(done, std::min(reported, order.size() - done));
            const std::size_t groups = (batch.size() + kGroup - 1) / kGroup;
            tbb::parallel_for(tbb::blocked_range<std::size_t>(0, groups, grain), [&](const auto& part) {
                progress.throwIfCancelled();
                auto work = makeWorker();
                for (std::size_t group = part.begin(); group < part.end(); ++group)
                    work(batch.subspan(group * kGroup, std::min(kGroup, batch.size() - group * kGroup)));
            });
        }
    }
    progress.throwIfCancelled();
}

/// A group's queries beside each other, in room that is used again.
class GroupQueries {
  public:
    std::span<const Eigen::Vector3d> gather(std::span<const Eigen::Vector3d> queries,
                                            std::span<const std::uint32_t> group) {
        for (std::size_t i = 0; i < group.size(); ++i)
            points_[i] = queries[group[i]];
        return std::span(points_).first(group.size());
    }

  private:
    std::array<Eigen::Vector3d, kGroup> points_;
};

}  // namespace

struct NeighbourIndex::Tree {
    explicit Tree(std::span<const Eigen::Vector3d> points) : blocks(points) {}
    BlockTree blocks;
};

NeighbourIndex::NeighbourIndex(std::span<const Eigen::Vector3d> points) {
    check(points);
    tree_ = std::make_unique<Tree>(points);
}
NeighbourIndex::~NeighbourIndex() = default;
NeighbourIndex::NeighbourIndex(NeighbourIndex&&) noexcept = default;
NeighbourIndex& NeighbourIndex::operator=(NeighbourIndex&&) noexcept = default;

std::size_t NeighbourIndex::size() const {
    return tree_->blocks.size();
}

Neighbour NeighbourIndex::nearest(const Eigen::Vector3d& query) const {
    Nearest nearest;
    search(tree_->blocks, query, nearest);
    return nearest.best();
}

std::vector<Neighbour> NeighbourIndex::kNearest(const Eigen::Vector3d& query, std::size_t k) const {
    if (k == 0) return {};
    KNearest nearest;
    nearest.start(std::min(k, size()));
    search(tree_->blocks, query, nearest);
    const std::span<const Neighbour> found = nearest.sorted();
    return {found.begin(), found.end()};
}

std::vector<Neighbour> NeighbourIndex::withinRadius(const Eigen::Vector3d& query, double radius_m) const {
    if (!(radius_m >= 0.0)) return {};
    WithinRadius within;
    within.start(std::min(radius_m * radius_m, kAnywhere_m2));
    search(tree_->blocks, query, within);
    const std::span<const Neighbour> found = within.sorted();
    return {found.begin(), found.end()};
}

std::vector<Neighbour> NeighbourIndex::nearestOfEach(std::span<const Eigen::Vector3d> queries, Progress& progress,
                                                     const std::string& stage) const {
    std::vector<Neighbour> neighbours(queries.size());
    forEachGroup(queries, progress, stage, [&] {
        return [&, near = GroupQueries()](std::span<const std::uint32_t> group) mutable {
            std::array<Nearest, kGroup> nearest;
            search(tree_->blocks, near.gather(queries, group), std::span(nearest).first(group.size()));
            for (std::size_t i = 0; i < group.size(); ++i)
                neighbours[group[i]] = nearest[i].best();
        };
    });
    return neighbours;
}

void NeighbourIndex::forEachKNearest(std::span<const Eigen::Vector3d> queries, std::size_t k,
                                     const std::function<void(std::size_t, std::span<const Neighbour>)>& use,
                                     Progress& progress, const std::string& stage) const {
    if (k == 0) return;
    const std::size_t count = std::min(k, size());
    forEachGroup(queries, progress, stage, [&] {
        return [&, near = GroupQueries(),
                nearest = std::array<KNearest, kGroup>()](std::span<const std::uint32_t> group) mutable {
            const auto collectors = std::span(nearest).first(group.size());
            for (KNearest& collector : collectors)
                collector.start(count);
            search(tree_->blocks, near.gather(queries, group), collectors);
            for (std::size_t i = 0; i < group.size(); ++i)
                use(group[i], collectors[i].sorted());
        };
    });
}

void NeighbourIndex::forEachWithinRadius(std::span<const Eigen::Vector3d> queries, double radius_m,
                                         const std::function<void(std::size_t, std::span<const Neighbour>)>& use,
                                         Progress& progress, const std::string& stage) const {
    if (!(radius_m >= 0.0)) return;
    forEachGroup(queries, progress, stage, [&] {
        return [&, near = GroupQueries(),
                within = std::array<WithinRadius, kGroup>()](std::span<const std::uint32_t> group) mutable {
            const auto collectors = std::span(within).first(group.size());
            for (WithinRadius& collector : collectors)
                collector.start(std::min(radius_m * radius_m, kAnywhere_m2));
            search(tree_->blocks, near.gather(queries, group), collectors);
            for (std::size_t i = 0; i < group.size(); ++i)
                use(group[i], collectors[i].found());
        };
    });
}

}  // namespace fodscope
