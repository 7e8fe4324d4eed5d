// SPDX-License-Identifier: MIT
#include "core/cloud/NeighbourIndex.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <thread>

#include "core/cloud/BlockTree.h"
#include "core/cloud/GroupSearch.h"
#include "core/cloud/KNearest.h"
#include "core/cloud/QueryGroups.h"
#include "core/common/Error.h"

namespace fodscope {
namespace {

/// The one nearest point of a query.
class Nearest {
  public:
    double reach() const { return best_.squaredDistance_m2; }
    void add(const BlockKernels& kernels, const PointBlock& block, const Eigen::Vector3d& query) {
        BlockDistances distances;
        const std::uint32_t within = kernels.squaredDistances(block, query, reach(), distances);
        forEachBit(within, [&](std::size_t i) {
            const Neighbour found{block.original[i], distances[i]};
            if (isNearer(found, best_)) best_ = found;
        });
    }
    Neighbour best() const { return best_.index == kNowhere ? kInfinitelyFar : best_; }

  private:
    Neighbour best_{kNowhere, kAnywhere_m2};
};

/// All points up to a distance.
class WithinRadius {
  public:
    void start(double squaredRadius_m2) {
        reach_ = squaredRadius_m2;
        found_.clear();
    }
    double reach() const { return reach_; }
    void add(const BlockKernels& kernels, const PointBlock& block, const Eigen::Vector3d& query) {
        found_.take(kernels, block, query, reach_);
    }
    /// In the order of the search, which is the same every time.
    std::span<const Neighbour> found() {
        inOrder_.clear();
        for (std::size_t i = 0; i < found_.size(); ++i)
            inOrder_.push_back(found_[i]);
        return inOrder_;
    }
    std::span<const Neighbour> sorted() {
        found();
        std::sort(inOrder_.begin(), inOrder_.end(), isNearer);
        return inOrder_;
    }

  private:
    double reach_ = 0.0;
    FoundPoints found_;
    std::vector<Neighbour> inOrder_;
};

/// Lets a collector meet the points within its reach of one query.
template <class Collector>
void search(const BlockTree& tree, const Eigen::Vector3d& query, Collector& collector) {
    PointBlock room;
    tree.visit(
        PointBox{query, query}, [&] { return collector.reach(); },
        [&](std::uint32_t number) { collector.add(tree.kernels(), tree.block(number, room), query); });
}

void check(std::span<const Eigen::Vector3d> points) {
    if (points.empty()) throw Error("point cloud", "it has no points to search among", "give a cloud with points");
    if (points.size() >= kNowhere) {
        throw Error("point cloud", "it has more than 4 billion points", "thin it out first");
    }
    const bool areFinite = tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, points.size(), 1 << 14), true,
        [&](const auto& part, bool are) {
            for (std::size_t i = part.begin(); are && i < part.end(); ++i)
                are = points[i].allFinite();
            return are;
        },
        std::logical_and<>());
    if (!areFinite) throw Error("point cloud", "a coordinate is not finite", "drop such points first");
}

/// Calls `work(group)` for all groups of queries, in parallel; each run of groups has a `work` of its own. Only the
/// calling thread reports.
template <class MakeWork>
void forEachGroup(const BlockTree& tree, std::span<const Eigen::Vector3d> queries, Progress& progress,
                  const std::string& stage, const MakeWork& makeWork) {
    constexpr std::size_t steps = 100;
    if (!stage.empty()) progress.report(stage, 0.0);
    const QueryGroups groups(queries, tree, progress);
    const std::size_t runs = groups.runCount();
    const std::thread::id caller = std::this_thread::get_id();
    std::atomic<std::size_t> done = 0;
    std::size_t reported = 0;
    tbb::parallel_for(std::size_t{0}, runs, [&](std::size_t run) {
        auto work = makeWork();
        groups.forEachOf(run, [&](const QueryGroup& group) {
            progress.throwIfCancelled();
            work(group);
        });
        const std::size_t step = ++done * steps / runs;
        if (stage.empty() || std::this_thread::get_id() != caller || step == reported) return;
        reported = step;
        progress.report(stage, static_cast<double>(step) / steps);
    });
    progress.throwIfCancelled();
    if (!stage.empty()) progress.report(stage, 1.0);
}

}  // namespace

NeighbourIndex::NeighbourIndex(std::span<const Eigen::Vector3d> points) : NeighbourIndex(points, Progress()) {}

NeighbourIndex::NeighbourIndex(std::span<const Eigen::Vector3d> points, const Progress& progress)
    : NeighbourIndex(points, progress, bestKernels()) {}

NeighbourIndex::NeighbourIndex(std::span<const Eigen::Vector3d> points, const Progress& progress,
                               const BlockKernels& kernels) {
    check(points);
    tree_ = std::make_unique<BlockTree>(points, kernels, progress);
}

NeighbourIndex::~NeighbourIndex() = default;
NeighbourIndex::NeighbourIndex(NeighbourIndex&&) noexcept = default;
NeighbourIndex& NeighbourIndex::operator=(NeighbourIndex&&) noexcept = default;

std::size_t NeighbourIndex::size() const {
    return tree_->size();
}

Neighbour NeighbourIndex::nearest(const Eigen::Vector3d& query) const {
    Nearest nearest;
    search(*tree_, query, nearest);
    return nearest.best();
}

std::vector<Neighbour> NeighbourIndex::kNearest(const Eigen::Vector3d& query, std::size_t k) const {
    if (k == 0) return {};
    KNearest nearest;
    nearest.start(std::min(k, size()));
    search(*tree_, query, nearest);
    const std::span<const Neighbour> found = nearest.sorted(tree_->kernels());
    return {found.begin(), found.end()};
}

std::vector<Neighbour> NeighbourIndex::withinRadius(const Eigen::Vector3d& query, double radius_m) const {
    if (!(radius_m >= 0.0)) return {};
    WithinRadius within;
    within.start(std::min(radius_m * radius_m, kAnywhere_m2));
    search(*tree_, query, within);
    const std::span<const Neighbour> found = within.sorted();
    return {found.begin(), found.end()};
}

std::vector<Neighbour> NeighbourIndex::nearestOfEach(std::span<const Eigen::Vector3d> queries, Progress& progress,
                                                     const std::string& stage) const {
    std::vector<Neighbour> neighbours(queries.size());
    forEachGroup(*tree_, queries, progress, stage, [&] {
        return [&](const QueryGroup& group) {
            const NearestOfGroup nearest(*tree_, group);
            for (std::size_t i = 0; i < group.count; ++i)
                neighbours[group.queries.original[i]] = nearest[i];
        };
    });
    return neighbours;
}

void NeighbourIndex::forEachKNearest(std::span<const Eigen::Vector3d> queries, std::size_t k,
                                     const std::function<void(std::size_t, std::span<const Neighbour>)>& use,
                                     Progress& progress, const std::string& stage) const {
    if (k == 0) return;
    forEachGroup(*tree_, queries, progress, stage, [&] {
        return [&, nearest = KNearestOfGroups(*tree_, std::min(k, size()))](const QueryGroup& group) mutable {
            nearest.search(group, use);
        };
    });
}

void NeighbourIndex::forEachWithinRadius(std::span<const Eigen::Vector3d> queries, double radius_m,
                                         const std::function<void(std::size_t, std::span<const Neighbour>)>& use,
                                         Progress& progress, const std::string& stage) const {
    if (!(radius_m >= 0.0)) return;
    BlockDistances reaches;
    reaches.fill(std::min(radius_m * radius_m, kAnywhere_m2));
    forEachGroup(*tree_, queries, progress, stage, [&] {
        return [&, within = std::array<WithinRadius, kBlockSize>()](const QueryGroup& group) mutable {
            for (WithinRadius& each : within)
                each.start(reaches.front());
            meetBlocks(*tree_, group, reaches, [&](const PointBlock& block, std::uint32_t near) {
                forEachBit(near,
                           [&](std::size_t i) { within[i].add(tree_->kernels(), block, group.queries.point(i)); });
                return false;
            });
            for (std::size_t i = 0; i < group.count; ++i)
                use(group.queries.original[i], within[i].found());
        };
    });
}

}  // namespace fodscope
