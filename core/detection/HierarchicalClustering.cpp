// SPDX-License-Identifier: MIT
#include "core/detection/HierarchicalClustering.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <string>
#include <tuple>

#include "core/common/Error.h"
#include "core/detection/CentroidTree.h"

namespace fodscope {
namespace {

/// Points at the same place are merged at distance 0 before anything else and their centroid does not move, so they
/// may start as one cluster with a weight. Clusters are in the order of their first points.
struct Places {
    std::vector<Eigen::Vector3d> positions;
    std::vector<double> weights;
    std::vector<std::uint32_t> placeOfPoint;
};

Places placesOf(std::span<const Eigen::Vector3d> points) {
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t i) { return std::tie(points[i].x(), points[i].y(), points[i].z()); };
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b) || (key(a) == key(b) && a < b); });
    // The first point of each place stands for it.
    std::vector<std::uint32_t> firstPoint(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool isSame = i > 0 && key(order[i]) == key(order[i - 1]);
        firstPoint[order[i]] = isSame ? firstPoint[order[i - 1]] : order[i];
    }
    Places places;
    places.placeOfPoint.resize(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        if (firstPoint[i] == i) {
            places.placeOfPoint[i] = static_cast<std::uint32_t>(places.positions.size());
            places.positions.push_back(points[i]);
            places.weights.push_back(1.0);
        } else {
            places.placeOfPoint[i] = places.placeOfPoint[firstPoint[i]];
            places.weights[places.placeOfPoint[i]] += 1.0;
        }
    }
    return places;
}

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
    CentroidLinkage(const Places& places, double cutoff_m)
        : tree_(places.positions),
          weights_(places.weights),
          parents_(places.positions.size()),
          versions_(places.positions.size(), 0),
          cutoff_m_(cutoff_m) {
        std::iota(parents_.begin(), parents_.end(), 0u);
    }

    void run(Progress& progress) {
        for (std::uint32_t id = 0; id < parents_.size(); ++id) {
            if (id % 4096 == 0) progress.report("clustering", 0.0);
            enterNearest(id);
        }
        for (std::size_t step = 0; !queue_.empty(); ++step) {
            if (step % 4096 == 0) {
                progress.report("clustering", static_cast<double>(merges_) / static_cast<double>(parents_.size()));
            }
            const Pair pair = queue_.top();
            queue_.pop();
            if (!tree_.isActive(pair.owner) || versions_[pair.owner] != pair.ownerVersion) continue;
            if (tree_.isActive(pair.partner) && versions_[pair.partner] == pair.partnerVersion) {
                merge(std::min(pair.owner, pair.partner), std::max(pair.owner, pair.partner));
            } else {
                enterNearest(pair.owner);
            }
        }
    }

    /// @return the cluster's first place
    std::uint32_t rootOf(std::uint32_t id) {
        while (parents_[id] != id)
            id = parents_[id] = parents_[parents_[id]];
        return id;
    }

  private:
    void enterNearest(std::uint32_t id) {
        // The square of the cutoff may be rounded down; the root below decides.
        const double limit = cutoff_m_ * cutoff_m_ * (1.0 + 1e-12);
        const auto found = tree_.nearestOther(id, limit);
        if (!found || !(std::sqrt(found->squaredDistance) <= cutoff_m_)) return;
        queue_.push({found->squaredDistance, id, found->id, versions_[id], versions_[found->id]});
    }

    void merge(std::uint32_t kept, std::uint32_t removed) {
        const double weight = weights_[kept] + weights_[removed];
        const Eigen::Vector3d step = tree_.point(removed) - tree_.point(kept);
        tree_.merge(kept, removed, tree_.point(kept) + step * (weights_[removed] / weight));
        weights_[kept] = weight;
        parents_[removed] = kept;
        ++versions_[kept];
        ++merges_;
        enterNearest(kept);
    }

    CentroidTree tree_;
    std::vector<double> weights_;
    std::vector<std::uint32_t> parents_;
    std::vector<std::uint32_t> versions_;
    std::priority_queue<Pair, std::vector<Pair>, std::greater<>> queue_;
    double cutoff_m_;
    std::size_t merges_ = 0;
};

}  // namespace

std::vector<std::uint32_t> centroidLinkageClusters(std::span<const Eigen::Vector3d> points, double cutoff_m,
                                                   Progress& progress) {
    if (!(cutoff_m >= 0.0) || !std::isfinite(cutoff_m)) {
        throw Error("cluster cutoff", "must be a finite length of at least 0 m", "give for example 0.345");
    }
    if (points.empty()) return {};
    const Places places = placesOf(points);
    CentroidLinkage linkage(places, cutoff_m);
    linkage.run(progress);

    constexpr std::uint32_t unnumbered = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> numbers(places.positions.size(), unnumbered);
    std::vector<std::uint32_t> labels(points.size());
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::uint32_t& number = numbers[linkage.rootOf(places.placeOfPoint[i])];
        if (number == unnumbered) number = next++;
        labels[i] = number;
    }
    return labels;
}

}  // namespace fodscope
