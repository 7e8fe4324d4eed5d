// SPDX-License-Identifier: MIT
#include "core/detection/LinkageRound.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>

#include "core/detection/PairQueue.h"

namespace fodscope {
namespace {

constexpr std::size_t kReportEvery = 4096;

/// Says quickly that no new cluster is about: their number in tiles several reaches wide, found by hashing.
class NewClusterTiles {
  public:
    explicit NewClusterTiles(double reach_m) : reach_m_(reach_m), tilesPerMetre_(1.0 / (kTileWidth * reach_m)) {}

    void add(const Eigen::Vector3d& place) { ++counts_[tileOf(place)]; }
    void remove(const Eigen::Vector3d& place) { --counts_[tileOf(place)]; }

    bool anyNear(const Eigen::Vector3d& place) const {
        const Eigen::Vector3d low = (place.array() - reach_m_) * tilesPerMetre_;
        const Eigen::Vector3d high = (place.array() + reach_m_) * tilesPerMetre_;
        for (std::int64_t x = wholeBelow(low.x()); x <= wholeBelow(high.x()); ++x)
            for (std::int64_t y = wholeBelow(low.y()); y <= wholeBelow(high.y()); ++y)
                for (std::int64_t z = wholeBelow(low.z()); z <= wholeBelow(high.z()); ++z)
                    if (counts_[hash(x, y, z)] > 0) return true;
        return false;
    }

  private:
    static constexpr double kTileWidth = 6.0;
    static constexpr std::size_t kTiles = 1u << 14;

    static std::size_t hash(std::int64_t x, std::int64_t y, std::int64_t z) {
        const std::uint64_t mixed = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15u +
                                    static_cast<std::uint64_t>(y) * 0xC2B2AE3D27D4EB4Fu +
                                    static_cast<std::uint64_t>(z) * 0x165667B19E3779F9u;
        return mixed >> 24 & (kTiles - 1);
    }

    std::size_t tileOf(const Eigen::Vector3d& place) const {
        const Eigen::Vector3d tile = place * tilesPerMetre_;
        return hash(wholeBelow(tile.x()), wholeBelow(tile.y()), wholeBelow(tile.z()));
    }

    double reach_m_;
    double tilesPerMetre_;
    std::vector<std::uint32_t> counts_ = std::vector<std::uint32_t>(kTiles, 0);
};

/// See the header. Each living new cluster has one pair in the queue, its own or a mutual one, or had no neighbour
/// within the limit among those that lived when it was last moved. A pair's distance is thus a lower bound over all
/// pairs of its owner with clusters as old as its entry or older; of every two clusters the one that moved later has
/// looked at the other. So the head of the queue, when it still exists, is the closest of all pairs that it stands for.
/// Source: the lazily updated queue of D. Müllner, "Modern hierarchical, agglomerative clustering algorithms" (2011),
/// section 3.3, with a grid in place of the distance matrix.
class Round {
  public:
    Round(ClusterGrid& grid, double largestSquaredDistance)
        : grid_(grid), limit_(largestSquaredDistance), isNew_(grid.size(), 1), tiles_(grid.cell_m()) {}

    /// Takes the clusters that the remembered round began with for old.
    void remember(const RoundRecord& before, std::vector<std::uint32_t>& slotOfId) {
        for (const LivingCluster& cluster : before.start)
            slotOfId[cluster.id] = ClusterGrid::kNone;
        for (std::uint32_t slot = 0; slot < grid_.size(); ++slot)
            slotOfId[grid_.id(slot)] = slot;
        for (const LivingCluster& cluster : before.start) {
            const std::uint32_t slot = slotOfId[cluster.id];
            if (slot == ClusterGrid::kNone) continue;
            if (grid_.centroid(slot) == cluster.centroid && grid_.count(slot) == cluster.count) isNew_[slot] = 0;
        }
        before_ = before.merges;
        slotOfId_ = slotOfId;
    }

    std::vector<RoundMerge> run(const LinkageProgress& progress) {
        const auto news = static_cast<std::size_t>(std::ranges::count(isNew_, 1));
        PairQueue<Order> queue(limit_, news, Order{&grid_});
        queue_ = &queue;
        merges_.reserve(std::max<std::size_t>(before_.size(), news / 2));
        enterNew(progress);
        for (std::size_t step = 0;; ++step) {
            if (step % kReportEvery == 0) progress.report(merges_.size());
            skipWhatIsGone();
            const ClusterPair* head = queue.top();
            if (nextBefore_ < before_.size() && (head == nullptr || rank(before_[nextBefore_]) < rank(*head)))
                repeat(before_[nextBefore_++]);
            else if (head != nullptr)
                take(queue.pop());
            else
                return std::move(merges_);
        }
    }

  private:
    using Rank = std::tuple<double, std::uint32_t, std::uint32_t>;

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

    Rank rank(const ClusterPair& pair) const {
        const auto [low, high] = std::minmax({grid_.id(pair.owner), grid_.id(pair.partner)});
        return {pair.squaredDistance, low, high};
    }
    static Rank rank(const RoundMerge& merge) { return {merge.squaredDistance, merge.kept, merge.removed}; }

    void enterNew(const LinkageProgress& progress) {
        constexpr std::size_t part = 1u << 16;
        std::vector<std::uint32_t> slots;
        for (std::uint32_t slot = 0; slot < grid_.size(); ++slot)
            if (isNew_[slot]) slots.push_back(slot);
        std::vector<ClusterGrid::Found> nearest(slots.size());
        for (std::size_t begin = 0; begin < slots.size(); begin += part) {
            progress.report(0);
            const std::size_t end = std::min(slots.size(), begin + part);
            // What else waits for a thread must not be run within this.
            tbb::this_task_arena::isolate([&] {
                tbb::parallel_for(tbb::blocked_range<std::size_t>(begin, end, 2048), [&](const auto& range) {
                    for (std::size_t i = range.begin(); i < range.end(); ++i)
                        nearest[i] = grid_.nearestOther(slots[i], limit_);
                });
            });
        }
        // Where all are new, and nothing is remembered, slots are their own indices.
        const bool areAllNew = slots.size() == grid_.size();
        for (std::size_t i = 0; i < slots.size(); ++i) {
            const std::uint32_t slot = slots[i];
            const std::uint32_t other = nearest[i].slot;
            if (!before_.empty()) tiles_.add(grid_.centroid(slot));
            if (other == ClusterGrid::kNone) continue;
            const bool isMutual = areAllNew && nearest[other].slot == slot;
            if (isMutual && other < slot) continue;
            queue_->push({nearest[i].squaredDistance, slot, other, 0, 0, isMutual});
        }
    }

    void enter(std::uint32_t slot, const ClusterGrid::Found& found) {
        if (found.slot == ClusterGrid::kNone) return;
        queue_->push({found.squaredDistance, slot, found.slot, grid_.version(slot), grid_.version(found.slot), false});
    }

    void enterNearest(std::uint32_t slot) {
        if (isNew_[slot])
            enter(slot, grid_.nearestOther(slot, limit_));
        else if (tiles_.anyNear(grid_.centroid(slot)))
            enter(slot, grid_.nearestFlagged(slot, limit_, isNew_));
    }

    bool isOld(std::uint32_t id) const {
        const std::uint32_t slot = slotOfId_[id];
        return slot != ClusterGrid::kNone && !isNew_[slot];
    }

    void skipWhatIsGone() {
        for (; nextBefore_ < before_.size(); ++nextBefore_) {
            const RoundMerge& merge = before_[nextBefore_];
            const bool keptIsOld = isOld(merge.kept);
            const bool removedIsOld = isOld(merge.removed);
            if (keptIsOld && removedIsOld) return;
            if (keptIsOld || removedIsOld) makeNew(slotOfId_[keptIsOld ? merge.kept : merge.removed]);
        }
    }

    void makeNew(std::uint32_t slot) {
        isNew_[slot] = 1;
        tiles_.add(grid_.centroid(slot));
        enterNearest(slot);
    }

    void repeat(const RoundMerge& merge) {
        merges_.push_back(merge);
        enterNearest(grid_.merge(slotOfId_[merge.kept], slotOfId_[merge.removed]));
    }

    void take(const ClusterPair& pair) {
        const bool ownerStands = grid_.version(pair.owner) == pair.ownerVersion;
        const bool partnerStands = grid_.version(pair.partner) == pair.partnerVersion;
        if (ownerStands && partnerStands)
            merge(pair);
        else if (ownerStands)
            enterNearest(pair.owner);
        else if (partnerStands && pair.isMutual)
            enterNearest(pair.partner);
    }

    void merge(const ClusterPair& pair) {
        const auto [kept, removed] = std::minmax({grid_.id(pair.owner), grid_.id(pair.partner)});
        merges_.push_back({kept, removed, pair.squaredDistance});
        if (!before_.empty())
            for (const std::uint32_t slot : {pair.owner, pair.partner})
                if (isNew_[slot]) tiles_.remove(grid_.centroid(slot));
        // What is merged into another is new as well: no remembered merge may take it for old.
        isNew_[pair.owner] = 1;
        isNew_[pair.partner] = 1;
        const std::uint32_t slot = grid_.merge(pair.owner, pair.partner);
        if (!before_.empty()) tiles_.add(grid_.centroid(slot));
        enterNearest(slot);
    }

    ClusterGrid& grid_;
    double limit_;
    /// Per slot; old ones are those of the remembered round.
    std::vector<std::uint8_t> isNew_;
    NewClusterTiles tiles_;
    std::span<const RoundMerge> before_;
    std::span<const std::uint32_t> slotOfId_;
    std::size_t nextBefore_ = 0;
    PairQueue<Order>* queue_ = nullptr;
    std::vector<RoundMerge> merges_;
};

}  // namespace

std::vector<RoundMerge> runRound(std::vector<LivingCluster>& clusters, double reach_m, double largestSquaredDistance,
                                 const LinkageProgress& progress) {
    ClusterGrid grid(clusters, reach_m);
    clusters = {};
    std::vector<RoundMerge> merges = Round(grid, largestSquaredDistance).run(progress);
    clusters = grid.release();
    return merges;
}

std::vector<RoundMerge> replayRound(const RoundRecord& before, std::vector<LivingCluster>& clusters, double reach_m,
                                    double largestSquaredDistance, std::vector<std::uint32_t>& slotOfId,
                                    const LinkageProgress& progress) {
    ClusterGrid grid(clusters, reach_m);
    clusters = {};
    Round round(grid, largestSquaredDistance);
    round.remember(before, slotOfId);
    std::vector<RoundMerge> merges = round.run(progress);
    clusters = grid.release();
    return merges;
}

}  // namespace fodscope
