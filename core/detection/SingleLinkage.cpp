// SPDX-License-Identifier: MIT
#include "core/detection/SingleLinkage.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <tuple>

#include "core/detection/SquaredDistance.h"

namespace fodscope {
namespace {

constexpr std::size_t kLeafSize = 8;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

struct Edge {
    double squaredDistance = 0.0;
    std::uint32_t from = kNone;
    std::uint32_t to = kNone;
};

class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0u); }

    /// @return the lowest member
    std::uint32_t rootOf(std::uint32_t id) {
        while (parents_[id] != id)
            id = parents_[id] = parents_[parents_[id]];
        return id;
    }

    void join(std::uint32_t kept, std::uint32_t removed) { parents_[removed] = kept; }

  private:
    std::vector<std::uint32_t> parents_;
};

/// The shortest edges that hold together what the cutoff allows to hold together: of all trees that span the points,
/// one with the least edges, without those beyond the cutoff. Cutting it at a distance gives the clusters of single
/// linkage at that distance. Every round joins each component to its nearest other one (Borůvka 1926), found in a
/// kd-tree that skips boxes which lie in the component entirely. Source: W. March, P. Ram, A. Gray, "Fast Euclidean
/// minimum spanning tree" (2010), with one tree.
class SpanningForest {
  public:
    SpanningForest(std::span<const Eigen::Vector3d> places, double cutoff_m)
        : original_(places.size()),
          points_(places.begin(), places.end()),
          components_(places.size()),
          atLeast_(places.size(), 0.0),
          cutoff_m_(cutoff_m) {
        std::iota(original_.begin(), original_.end(), 0u);
        nodes_.emplace_back();
        divide(places, 0, 0, static_cast<std::uint32_t>(places.size()));
        for (std::size_t i = 0; i < original_.size(); ++i)
            points_[i] = places[original_[i]];
    }

    /// @return edges between places, in any order
    std::vector<Edge> run(Progress& progress) {
        std::vector<Edge> edges;
        DisjointSets sets(points_.size());
        while (joinNearest(sets, edges, progress)) {
        }
        for (Edge& edge : edges) {
            edge.from = original_[edge.from];
            edge.to = original_[edge.to];
        }
        return edges;
    }

  private:
    struct Node {
        Eigen::Vector3d low = Eigen::Vector3d::Zero();
        Eigen::Vector3d high = Eigen::Vector3d::Zero();
        std::uint32_t first = 0;
        std::uint32_t last = 0;
        /// kNone for a leaf; the second child is the next node.
        std::uint32_t firstChild = kNone;
        /// The one component of all points within; kNone: there are several.
        std::uint32_t component = kNone;
    };

    void divide(std::span<const Eigen::Vector3d> places, std::uint32_t node, std::uint32_t first, std::uint32_t last) {
        Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
        Eigen::Vector3d high = -low;
        for (std::uint32_t i = first; i < last; ++i) {
            low = low.cwiseMin(places[original_[i]]);
            high = high.cwiseMax(places[original_[i]]);
        }
        nodes_[node] = {low, high, first, last, kNone, kNone};
        if (last - first <= kLeafSize) return;
        int axis = 0;
        (high - low).maxCoeff(&axis);
        const std::uint32_t half = first + (last - first) / 2;
        std::nth_element(original_.begin() + first, original_.begin() + half, original_.begin() + last,
                         [&](std::uint32_t a, std::uint32_t b) {
                             return places[a][axis] < places[b][axis] || (places[a][axis] == places[b][axis] && a < b);
                         });
        const auto firstChild = static_cast<std::uint32_t>(nodes_.size());
        nodes_[node].firstChild = firstChild;
        nodes_.resize(nodes_.size() + 2);
        divide(places, firstChild, first, half);
        divide(places, firstChild + 1, half, last);
    }

    /// Children come after their parents.
    void markComponents() {
        for (std::size_t n = nodes_.size(); n-- > 0;) {
            Node& node = nodes_[n];
            if (node.firstChild != kNone) {
                const std::uint32_t one = nodes_[node.firstChild].component;
                node.component = one == nodes_[node.firstChild + 1].component ? one : kNone;
                continue;
            }
            node.component = components_[node.first];
            for (std::uint32_t i = node.first; i < node.last; ++i)
                if (components_[i] != node.component) node.component = kNone;
        }
    }

    bool joinNearest(DisjointSets& sets, std::vector<Edge>& edges, Progress& progress) {
        const auto count = static_cast<std::uint32_t>(points_.size());
        for (std::uint32_t i = 0; i < count; ++i)
            components_[i] = sets.rootOf(i);
        markComponents();
        // The square of the cutoff may be rounded down; the root below decides.
        const double limit =
            std::nextafter(cutoff_m_ * cutoff_m_ * (1.0 + 1e-12), std::numeric_limits<double>::infinity());
        std::vector<Edge> nearest(count, {limit, kNone, kNone});
        for (std::uint32_t i = 0; i < count; ++i) {
            if (i % 4096 == 0)
                progress.report("clustering", static_cast<double>(edges.size()) / static_cast<double>(count));
            Edge& best = nearest[components_[i]];
            if (atLeast_[i] >= best.squaredDistance) continue;
            // Components only grow: what is near to a point and foreign to it gets no nearer in later rounds.
            Edge found{best.squaredDistance, i, kNone};
            search(0, found);
            atLeast_[i] = found.squaredDistance;
            if (found.to != kNone) best = found;
        }
        const std::size_t before = edges.size();
        for (const Edge& edge : nearest) {
            if (edge.to == kNone || !(std::sqrt(edge.squaredDistance) <= cutoff_m_)) continue;
            const std::uint32_t a = sets.rootOf(edge.from);
            const std::uint32_t b = sets.rootOf(edge.to);
            if (a == b) continue;
            sets.join(std::min(a, b), std::max(a, b));
            edges.push_back(edge);
        }
        return edges.size() > before;
    }

    /// Rounding is monotonic, so this is never greater than the computed distance to a point within the box.
    double boxDistance(const Node& node, const Eigen::Vector3d& point) const {
        const Eigen::Vector3d within = point.cwiseMax(node.low).cwiseMin(node.high);
        return squaredDistance(point, within);
    }

    void search(std::uint32_t n, Edge& best) const {
        const Node& node = nodes_[n];
        if (node.component == components_[best.from]) return;
        if (node.firstChild == kNone) {
            for (std::uint32_t i = node.first; i < node.last; ++i) {
                if (components_[i] == components_[best.from]) continue;
                const double distance = squaredDistance(points_[best.from], points_[i]);
                if (distance < best.squaredDistance) best = {distance, best.from, i};
            }
            return;
        }
        std::uint32_t nearChild = node.firstChild;
        std::uint32_t farChild = node.firstChild + 1;
        double nearDistance = boxDistance(nodes_[nearChild], points_[best.from]);
        double farDistance = boxDistance(nodes_[farChild], points_[best.from]);
        if (farDistance < nearDistance) {
            std::swap(nearChild, farChild);
            std::swap(nearDistance, farDistance);
        }
        if (nearDistance < best.squaredDistance) search(nearChild, best);
        if (farDistance < best.squaredDistance) search(farChild, best);
    }

    /// The points are kept in the tree's order; indices of points are positions in it.
    std::vector<std::uint32_t> original_;
    std::vector<Eigen::Vector3d> points_;
    std::vector<std::uint32_t> components_;
    /// No point of another component is nearer than this (squared).
    std::vector<double> atLeast_;
    std::vector<Node> nodes_;
    double cutoff_m_;
};

}  // namespace

std::vector<Merge> singleMerges(std::span<const Eigen::Vector3d> places, double cutoff_m, Progress& progress) {
    if (places.empty()) return {};
    std::vector<Edge> edges = SpanningForest(places, cutoff_m).run(progress);
    const auto rank = [](const Edge& edge) {
        return std::tuple(edge.squaredDistance, std::min(edge.from, edge.to), std::max(edge.from, edge.to));
    };
    std::sort(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) { return rank(a) < rank(b); });
    std::vector<Merge> merges;
    merges.reserve(edges.size());
    DisjointSets clusters(places.size());
    for (const Edge& edge : edges) {
        const std::uint32_t a = clusters.rootOf(edge.from);
        const std::uint32_t b = clusters.rootOf(edge.to);
        merges.push_back({std::min(a, b), std::max(a, b), std::sqrt(edge.squaredDistance)});
        clusters.join(merges.back().kept, merges.back().removed);
    }
    return merges;
}

}  // namespace fodscope
