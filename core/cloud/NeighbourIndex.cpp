// SPDX-License-Identifier: MIT
#include "core/cloud/NeighbourIndex.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <nanoflann.hpp>

#include "core/cloud/MortonOrder.h"
#include "core/common/Error.h"

namespace fodscope {
namespace {

constexpr std::size_t kLeafSize = 12;

bool isNearer(const Neighbour& a, const Neighbour& b) {
    return a.squaredDistance_m2 < b.squaredDistance_m2 ||
           (a.squaredDistance_m2 == b.squaredDistance_m2 && a.index < b.index);
}

/// nanoflann leaves out points that are exactly as far as the worst found, and its lower bounds of branches carry a
/// little rounding. The bound it sees is therefore a trifle wider; the result sets below decide exactly.
double widened(double squaredDistance) {
    return squaredDistance * (1.0 + 1e-12) + std::numeric_limits<double>::min();
}

/// The tree's points in Morton order, and what nanoflann wants to ask of them.
struct OrderedPoints {
    std::vector<std::uint32_t> original;
    std::vector<Eigen::Vector3d> points;

    std::size_t kdtree_get_point_count() const { return points.size(); }
    double kdtree_get_pt(std::uint32_t index, std::size_t axis) const {
        return points[index][static_cast<Eigen::Index>(axis)];
    }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};

/// Result set of nanoflann: the one nearest point.
class Nearest {
  public:
    using DistanceType = double;

    explicit Nearest(const OrderedPoints& points) : points_(points) {}
    double worstDist() const { return widened(best_.squaredDistance_m2); }
    bool full() const { return true; }
    bool addPoint(double squaredDistance, std::uint32_t position) {
        const Neighbour candidate{points_.original[position], squaredDistance};
        if (isNearer(candidate, best_)) best_ = candidate;
        return true;
    }
    const Neighbour& best() const { return best_; }

  private:
    const OrderedPoints& points_;
    // Finite, so that the widened bound stays a number.
    Neighbour best_{0, std::numeric_limits<double>::max() / 2.0};
};

/// Result set of nanoflann: the k nearest points in a heap whose top is the farthest.
class KNearest {
  public:
    using DistanceType = double;

    KNearest(const OrderedPoints& points, std::size_t k, std::vector<Neighbour>& heap)
        : points_(points), k_(k), heap_(heap) {
        heap_.clear();
    }
    double worstDist() const { return worst_; }
    bool full() const { return heap_.size() == k_; }
    bool addPoint(double squaredDistance, std::uint32_t position) {
        const Neighbour candidate{points_.original[position], squaredDistance};
        if (heap_.size() < k_) {
            heap_.push_back(candidate);
            if (heap_.size() == k_) {
                std::make_heap(heap_.begin(), heap_.end(), isNearer);
                worst_ = widened(heap_.front().squaredDistance_m2);
            }
        } else if (isNearer(candidate, heap_.front())) {
            replaceFarthest(candidate);
            worst_ = widened(heap_.front().squaredDistance_m2);
        }
        return true;
    }
    void sort() { std::sort(heap_.begin(), heap_.end(), isNearer); }

  private:
    void replaceFarthest(const Neighbour& candidate) {
        std::size_t hole = 0;
        for (std::size_t child = 1; child < k_; child = 2 * hole + 1) {
            if (child + 1 < k_ && isNearer(heap_[child], heap_[child + 1])) ++child;
            if (!isNearer(candidate, heap_[child])) break;
            heap_[hole] = heap_[child];
            hole = child;
        }
        heap_[hole] = candidate;
    }

    const OrderedPoints& points_;
    std::size_t k_;
    std::vector<Neighbour>& heap_;
    double worst_ = std::numeric_limits<double>::max();
};

/// Result set of nanoflann: all points up to a distance.
class WithinRadius {
  public:
    using DistanceType = double;

    WithinRadius(const OrderedPoints& points, double squaredRadius, std::vector<Neighbour>& found)
        : points_(points), squaredRadius_(squaredRadius), found_(found) {
        found_.clear();
    }
    double worstDist() const { return widened(squaredRadius_); }
    bool full() const { return true; }
    bool addPoint(double squaredDistance, std::uint32_t position) {
        if (squaredDistance <= squaredRadius_) found_.push_back({points_.original[position], squaredDistance});
        return true;
    }

  private:
    const OrderedPoints& points_;
    double squaredRadius_;
    std::vector<Neighbour>& found_;
};

using KdTree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, OrderedPoints, double, std::uint32_t>,
                                        OrderedPoints, 3, std::uint32_t>;

OrderedPoints inMortonOrder(std::span<const Eigen::Vector3d> points) {
    if (points.empty()) throw Error("point cloud", "it has no points to search among", "give a cloud with points");
    if (points.size() > std::numeric_limits<std::uint32_t>::max()) {
        throw Error("point cloud", "it has more than 4 billion points", "thin it out first");
    }
    if (!std::all_of(points.begin(), points.end(), [](const Eigen::Vector3d& p) { return p.allFinite(); })) {
        throw Error("point cloud", "a coordinate is not finite", "drop such points first");
    }
    OrderedPoints ordered;
    ordered.original = mortonOrder(points);
    ordered.points.reserve(points.size());
    for (const std::uint32_t index : ordered.original)
        ordered.points.push_back(points[index]);
    return ordered;
}

/// Calls `use(indices)` for lists of queries that lie near each other, in parallel, until every query had its turn.
/// Only the calling thread reports.
template <class Use>
void forEachGroup(std::span<const Eigen::Vector3d> queries, Progress& progress, const std::string& stage,
                  const Use& use) {
    // Large enough to keep neighbours together, small enough to sort between two looks at the progress.
    constexpr std::size_t sorted = 1 << 18;
    constexpr std::size_t reported = 1 << 14;
    constexpr std::size_t grain = 256;
    for (std::size_t first = 0; first < queries.size(); first += sorted) {
        std::vector<std::uint32_t> order =
            mortonOrder(queries.subspan(first, std::min(sorted, queries.size() - first)));
        for (std::uint32_t& index : order)
            index += static_cast<std::uint32_t>(first);
        for (std::size_t done = 0; done < order.size(); done += reported) {
            if (!stage.empty())
                progress.report(stage, static_cast<double>(first + done) / static_cast<double>(queries.size()));
            const tbb::blocked_range<std::size_t> range(done, std::min(order.size(), done + reported), grain);
            tbb::parallel_for(range, [&](const tbb::blocked_range<std::size_t>& part) {
                progress.throwIfCancelled();
                use(std::span<const std::uint32_t>(order).subspan(part.begin(), part.size()));
            });
        }
    }
    progress.throwIfCancelled();
}

}  // namespace

struct NeighbourIndex::Tree {
    explicit Tree(std::span<const Eigen::Vector3d> points)
        : ordered(inMortonOrder(points)), tree(3, ordered, nanoflann::KDTreeSingleIndexAdaptorParams(kLeafSize)) {}

    template <class Result>
    void search(Result& result, const Eigen::Vector3d& query) const {
        tree.findNeighbors(result, query.data(), nanoflann::SearchParams());
    }

    OrderedPoints ordered;
    KdTree tree;
};

NeighbourIndex::NeighbourIndex(std::span<const Eigen::Vector3d> points) : tree_(std::make_unique<Tree>(points)) {}
NeighbourIndex::~NeighbourIndex() = default;
NeighbourIndex::NeighbourIndex(NeighbourIndex&&) noexcept = default;
NeighbourIndex& NeighbourIndex::operator=(NeighbourIndex&&) noexcept = default;

std::size_t NeighbourIndex::size() const {
    return tree_->ordered.points.size();
}

Neighbour NeighbourIndex::nearest(const Eigen::Vector3d& query) const {
    Nearest result(tree_->ordered);
    tree_->search(result, query);
    return result.best();
}

std::vector<Neighbour> NeighbourIndex::kNearest(const Eigen::Vector3d& query, std::size_t k) const {
    std::vector<Neighbour> neighbours;
    if (k == 0) return neighbours;
    KNearest result(tree_->ordered, std::min(k, size()), neighbours);
    tree_->search(result, query);
    result.sort();
    return neighbours;
}

std::vector<Neighbour> NeighbourIndex::withinRadius(const Eigen::Vector3d& query, double radius_m) const {
    std::vector<Neighbour> neighbours;
    if (!(radius_m >= 0.0)) return neighbours;
    WithinRadius result(tree_->ordered, radius_m * radius_m, neighbours);
    tree_->search(result, query);
    std::sort(neighbours.begin(), neighbours.end(), isNearer);
    return neighbours;
}

std::vector<Neighbour> NeighbourIndex::nearestOfEach(std::span<const Eigen::Vector3d> queries, Progress& progress,
                                                     const std::string& stage) const {
    std::vector<Neighbour> neighbours(queries.size());
    forEachGroup(queries, progress, stage, [&](std::span<const std::uint32_t> group) {
        for (const std::uint32_t i : group)
            neighbours[i] = nearest(queries[i]);
    });
    return neighbours;
}

void NeighbourIndex::forEachKNearest(std::span<const Eigen::Vector3d> queries, std::size_t k,
                                     const std::function<void(std::size_t, std::span<const Neighbour>)>& use,
                                     Progress& progress, const std::string& stage) const {
    if (k == 0) return;
    const std::size_t count = std::min(k, size());
    forEachGroup(queries, progress, stage, [&](std::span<const std::uint32_t> group) {
        std::vector<Neighbour> neighbours;
        neighbours.reserve(count);
        for (const std::uint32_t i : group) {
            KNearest result(tree_->ordered, count, neighbours);
            tree_->search(result, queries[i]);
            result.sort();
            use(i, neighbours);
        }
    });
}

void NeighbourIndex::forEachWithinRadius(std::span<const Eigen::Vector3d> queries, double radius_m,
                                         const std::function<void(std::size_t, std::span<const Neighbour>)>& use,
                                         Progress& progress, const std::string& stage) const {
    if (!(radius_m >= 0.0)) return;
    forEachGroup(queries, progress, stage, [&](std::span<const std::uint32_t> group) {
        std::vector<Neighbour> neighbours;
        for (const std::uint32_t i : group) {
            WithinRadius result(tree_->ordered, radius_m * radius_m, neighbours);
            tree_->search(result, queries[i]);
            use(i, neighbours);
        }
    });
}

}  // namespace fodscope
