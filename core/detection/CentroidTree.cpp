// SPDX-License-Identifier: MIT
#include "core/detection/CentroidTree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fodscope {
namespace {

constexpr std::size_t kLeafSize = 8;

}  // namespace

CentroidTree::CentroidTree(std::span<const Eigen::Vector3d> points)
    : points_(points.begin(), points.end()), leafOf_(points.size(), 0), active_(points.size()) {
    build();
}

void CentroidTree::build() {
    std::vector<std::uint32_t> ids;
    ids.reserve(active_);
    for (std::uint32_t id = 0; id < points_.size(); ++id) {
        if (isActive(id)) ids.push_back(id);
    }
    activeWhenBuilt_ = active_;
    nodes_.assign(1, Node{});
    divide(0, ids);
}

void CentroidTree::divide(std::uint32_t node, std::span<std::uint32_t> ids) {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d high = -low;
    for (const std::uint32_t id : ids) {
        low = low.cwiseMin(points_[id]);
        high = high.cwiseMax(points_[id]);
    }
    nodes_[node].low = low;
    nodes_[node].high = high;
    if (ids.size() <= kLeafSize) {
        nodes_[node].ids.assign(ids.begin(), ids.end());
        for (const std::uint32_t id : ids)
            leafOf_[id] = node;
        return;
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    const std::size_t half = ids.size() / 2;
    std::nth_element(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(half), ids.end(),
                     [&](std::uint32_t a, std::uint32_t b) {
                         return points_[a][axis] < points_[b][axis] || (points_[a][axis] == points_[b][axis] && a < b);
                     });
    const auto firstChild = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].firstChild = firstChild;
    nodes_.resize(nodes_.size() + 2);
    nodes_[firstChild].parent = node;
    nodes_[firstChild + 1].parent = node;
    divide(firstChild, ids.first(half));
    divide(firstChild + 1, ids.subspan(half));
}

void CentroidTree::merge(std::uint32_t kept, std::uint32_t removed, const Eigen::Vector3d& position) {
    std::erase(nodes_[leafOf_[removed]].ids, removed);
    leafOf_[removed] = kNowhere;
    points_[kept] = position;
    --active_;
    if (2 * active_ < activeWhenBuilt_) {
        build();
        return;
    }
    for (std::uint32_t node = leafOf_[kept]; node != kNowhere; node = nodes_[node].parent) {
        nodes_[node].low = nodes_[node].low.cwiseMin(position);
        nodes_[node].high = nodes_[node].high.cwiseMax(position);
    }
}

/// Rounding is monotonic, so this is never greater than the computed distance to a point within the box.
double CentroidTree::boxDistance(const Node& node, const Eigen::Vector3d& point) const {
    const Eigen::Vector3d within = point.cwiseMax(node.low).cwiseMin(node.high);
    return squaredDistance(point, within);
}

std::optional<CentroidTree::Found> CentroidTree::nearestOther(std::uint32_t id, double largestSquaredDistance) const {
    Found best{kNowhere, largestSquaredDistance};
    search(0, id, best);
    if (best.id == kNowhere) return std::nullopt;
    return best;
}

void CentroidTree::search(std::uint32_t node, std::uint32_t id, Found& best) const {
    const Node& here = nodes_[node];
    if (here.firstChild == kNowhere) {
        for (const std::uint32_t other : here.ids) {
            if (other == id) continue;
            const double distance = squaredDistance(points_[id], points_[other]);
            const bool isNearer = distance < best.squaredDistance;
            const bool isTie = distance == best.squaredDistance && other < best.id;
            if (isNearer || isTie) best = {other, distance};
        }
        return;
    }
    std::uint32_t nearChild = here.firstChild;
    std::uint32_t farChild = here.firstChild + 1;
    double nearDistance = boxDistance(nodes_[nearChild], points_[id]);
    double farDistance = boxDistance(nodes_[farChild], points_[id]);
    if (farDistance < nearDistance) {
        std::swap(nearChild, farChild);
        std::swap(nearDistance, farDistance);
    }
    if (nearDistance <= best.squaredDistance) search(nearChild, id, best);
    if (farDistance <= best.squaredDistance) search(farChild, id, best);
}

}  // namespace fodscope
