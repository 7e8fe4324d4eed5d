// SPDX-License-Identifier: MIT
#include "core/detection/CentroidLinkage.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/detection/PairQueue.h"

namespace fodscope {
namespace {

constexpr std::size_t kReportEvery = 4096;
/// From the cutoff of a round to the next, and how many others may share the cell of a point in the first round.
constexpr double kRoundStep = 1.5;
constexpr double kCrowd = 1.5;
constexpr std::size_t kLeastSample = 2048;
constexpr int kMostRounds = 60;

/// @return the greatest square whose root is within the length
double largestSquareWithin(double length_m) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double square = length_m * length_m;
    while (std::sqrt(square) > length_m)
        square = std::nextafter(square, 0.0);
    while (square < infinity && std::sqrt(std::nextafter(square, infinity)) <= length_m)
        square = std::nextafter(square, infinity);
    return square;
}

double diameter(const std::vector<LivingCluster>& clusters) {
    Eigen::Vector3d low = clusters.front().centroid;
    Eigen::Vector3d high = low;
    for (const LivingCluster& cluster : clusters) {
        low = low.cwiseMin(cluster.centroid);
        high = high.cwiseMax(cluster.centroid);
    }
    return (high - low).norm();
}

/// About how many others share a cell with a cluster, from a sample.
double crowding(const std::vector<LivingCluster>& clusters, double cell_m) {
    const std::size_t wanted = std::max(kLeastSample, clusters.size() / 64);
    const std::size_t stride = std::max<std::size_t>(1, clusters.size() / wanted);
    std::vector<std::uint64_t> cells;
    for (std::size_t i = 0; i < clusters.size(); i += stride) {
        const Eigen::Vector3d at = clusters[i].centroid / cell_m;
        std::uint64_t cell = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double bounded = std::clamp(std::floor(at[axis]), -1e15, 1e15);
            cell = (cell ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(bounded))) * 0x9E3779B97F4A7C15u;
            cell ^= cell >> 29;
        }
        cells.push_back(cell);
    }
    std::ranges::sort(cells);
    double others = 0.0;
    std::size_t first = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i] != cells[first]) first = i;
        others += 2.0 * static_cast<double>(i - first);
    }
    return others / static_cast<double>(cells.size()) * static_cast<double>(stride);
}

/// One round: merges until no pair is within the limit.
class Round {
  public:
    Round(ClusterGrid& grid, double largestSquaredDistance, std::vector<Merge>& merges)
        : grid_(grid),
          limit_(largestSquaredDistance),
          merges_(merges),
          queue_(largestSquaredDistance, grid.size(), Order{&grid}) {}

    void run(double fractionBefore, Progress& progress) {
        enterAll(progress);
        ClusterPair pair;
        for (std::size_t step = 0; queue_.pop(pair); ++step) {
            if (step % kReportEvery == 0) progress.report("clustering", fractionBefore);
            const bool ownerStands = grid_.version(pair.owner) == pair.ownerVersion;
            const bool partnerStands = grid_.version(pair.partner) == pair.partnerVersion;
            if (ownerStands && partnerStands)
                merge(pair);
            else if (ownerStands)
                enterNearest(pair.owner);
            else if (partnerStands && pair.isMutual)
                enterNearest(pair.partner);
        }
    }

  private:
    /// The closest pair first, of equally close ones that with the lowest ids.
    struct Order {
        const ClusterGrid* grid;

        bool operator()(const ClusterPair& a, const ClusterPair& b) const {
            if (a.squaredDistance != b.squaredDistance) return a.squaredDistance < b.squaredDistance;
            return ids(a) < ids(b);
        }
        std::pair<std::uint32_t, std::uint32_t> ids(const ClusterPair& pair) const {
            return std::minmax({grid->id(pair.owner), grid->id(pair.partner)});
        }
    };

    void enterAll(Progress& progress) {
        constexpr std::uint32_t part = 1u << 16;
        std::vector<ClusterGrid::Found> nearest(grid_.size());
        for (std::uint32_t begin = 0; begin < grid_.size(); begin += std::min(part, grid_.size() - begin)) {
            progress.throwIfCancelled();
            const std::uint32_t end = begin + std::min(part, grid_.size() - begin);
            // What else waits for a thread must not be run within this.
            tbb::this_task_arena::isolate([&] {
                tbb::parallel_for(tbb::blocked_range<std::uint32_t>(begin, end, 2048), [&](const auto& range) {
                    for (std::uint32_t slot = range.begin(); slot < range.end(); ++slot)
                        nearest[slot] = grid_.nearestOther(slot, limit_);
                });
            });
        }
        for (std::uint32_t slot = 0; slot < grid_.size(); ++slot) {
            const std::uint32_t other = nearest[slot].slot;
            if (other == ClusterGrid::kNone) continue;
            const bool isMutual = nearest[other].slot == slot;
            if (isMutual && other < slot) continue;
            queue_.push({nearest[slot].squaredDistance, slot, other, 0, 0, isMutual});
        }
    }

    void enterNearest(std::uint32_t slot) {
        const ClusterGrid::Found found = grid_.nearestOther(slot, limit_);
        if (found.slot == ClusterGrid::kNone) return;
        queue_.push({found.squaredDistance, slot, found.slot, grid_.version(slot), grid_.version(found.slot), false});
    }

    void merge(const ClusterPair& pair) {
        const auto [kept, removed] = std::minmax({grid_.id(pair.owner), grid_.id(pair.partner)});
        merges_.push_back({kept, removed, std::sqrt(pair.squaredDistance)});
        enterNearest(grid_.merge(pair.owner, pair.partner));
    }

    ClusterGrid& grid_;
    double limit_;
    std::vector<Merge>& merges_;
    PairQueue<Order> queue_;
};

}  // namespace

// Each living cluster has one pair in the queue, its own or a mutual one, or had no neighbour within the round's cutoff
// among those that lived when it was last moved. A pair's distance is thus a lower bound over all pairs of its owner
// with clusters as old as its entry or older; of every two clusters the one that moved later has looked at the other.
// So the head of the queue, when it still exists, is the closest of all pairs. Source: the lazily updated queue of
// D. Müllner, "Modern hierarchical, agglomerative clustering algorithms" (2011), section 3.3, with a grid in place of
// the distance matrix.
void CentroidAgglomeration::advance(double cutoff_m, std::vector<Merge>& merges, Progress& progress) {
    progress.report("clustering", 0.0);
    if (living_.size() < 2 || cutoff_m == 0.0) return;
    const std::size_t all = living_.size();
    const double last_m = std::min(cutoff_m, 1.01 * diameter(living_));
    double reach_m = last_m;
    for (int round = 0; round < kMostRounds && crowding(living_, reach_m) > kCrowd; ++round)
        reach_m /= kRoundStep;
    while (living_.size() > 1) {
        const bool isLast = reach_m * 1.0001 >= last_m;
        ClusterGrid grid(std::exchange(living_, {}), isLast ? last_m : reach_m);
        const double done = 1.0 - static_cast<double>(grid.size()) / static_cast<double>(all);
        Round(grid, isLast ? largestSquareWithin(cutoff_m) : reach_m * reach_m, merges).run(done, progress);
        living_ = grid.release();
        if (isLast) break;
        reach_m *= kRoundStep;
    }
}

}  // namespace fodscope
