// SPDX-License-Identifier: MIT
#include "core/detection/CentroidLinkage.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <tuple>

#include "core/detection/CentroidTree.h"

namespace fodscope {
namespace {

/// A pair of clusters that was the closest one of `owner` when it was entered.
struct Pair {
    double squaredDistance;
    std::uint32_t owner;
    std::uint32_t partner;
    /// How often each had been merged then: the pair still exists only if neither moved since.
    std::uint32_t ownerVersion;
    std::uint32_t partnerVersion;

    auto rank() const { return std::tuple(squaredDistance, std::min(owner, partner), std::max(owner, partner)); }
    bool operator>(const Pair& other) const { return rank() > other.rank(); }
};

/// Each living cluster has one pair in the queue or, within the cutoff, no neighbour among those that lived when it
/// was last moved. A pair's distance is thus a lower bound over all pairs of its owner with clusters as old as its
/// entry or older; of every two clusters the one that moved later has looked at the other. So the head of the queue,
/// when it still exists, is the closest of all pairs. Source: the lazily updated queue of D. Müllner, "Modern
/// hierarchical, agglomerative clustering algorithms" (2011), section 3.3, with a kd-tree in place of the distance
/// matrix.
class CentroidLinkage {
  public:
    CentroidLinkage(std::span<const Eigen::Vector3d> places, std::span<const double> weights, double cutoff_m)
        : tree_(places), weights_(weights.begin(), weights.end()), versions_(places.size(), 0), cutoff_m_(cutoff_m) {}

    std::vector<Merge> run(Progress& progress) {
        for (std::uint32_t id = 0; id < versions_.size(); ++id) {
            if (id % 4096 == 0) progress.report("clustering", 0.0);
            enterNearest(id);
        }
        for (std::size_t step = 0; !queue_.empty(); ++step) {
            if (step % 4096 == 0) {
                progress.report("clustering",
                                static_cast<double>(merges_.size()) / static_cast<double>(versions_.size()));
            }
            const Pair pair = queue_.top();
            queue_.pop();
            if (!tree_.isActive(pair.owner) || versions_[pair.owner] != pair.ownerVersion) continue;
            if (tree_.isActive(pair.partner) && versions_[pair.partner] == pair.partnerVersion) {
                merge(pair);
            } else {
                enterNearest(pair.owner);
            }
        }
        return std::move(merges_);
    }

  private:
    void enterNearest(std::uint32_t id) {
        // The square of the cutoff may be rounded down; the root below decides.
        const double limit = cutoff_m_ * cutoff_m_ * (1.0 + 1e-12);
        const auto found = tree_.nearestOther(id, limit);
        if (!found || !(std::sqrt(found->squaredDistance) <= cutoff_m_)) return;
        queue_.push({found->squaredDistance, id, found->id, versions_[id], versions_[found->id]});
    }

    void merge(const Pair& pair) {
        const std::uint32_t kept = std::min(pair.owner, pair.partner);
        const std::uint32_t removed = std::max(pair.owner, pair.partner);
        const double weight = weights_[kept] + weights_[removed];
        const Eigen::Vector3d step = tree_.point(removed) - tree_.point(kept);
        tree_.merge(kept, removed, tree_.point(kept) + step * (weights_[removed] / weight));
        weights_[kept] = weight;
        ++versions_[kept];
        merges_.push_back({kept, removed, std::sqrt(pair.squaredDistance)});
        enterNearest(kept);
    }

    CentroidTree tree_;
    std::vector<double> weights_;
    std::vector<std::uint32_t> versions_;
    std::priority_queue<Pair, std::vector<Pair>, std::greater<>> queue_;
    double cutoff_m_;
    std::vector<Merge> merges_;
};

}  // namespace

std::vector<Merge> centroidMerges(std::span<const Eigen::Vector3d> places, std::span<const double> weights,
                                  double cutoff_m, Progress& progress) {
    return CentroidLinkage(places, weights, cutoff_m).run(progress);
}

}  // namespace fodscope
