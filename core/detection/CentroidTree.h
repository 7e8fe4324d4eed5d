// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace fodscope {

/// Squared distance whose every part is computed in the same order wherever it is needed, so that equal distances
/// compare as equal.
inline double squaredDistance(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const double x = a.x() - b.x();
    const double y = a.y() - b.y();
    const double z = a.z() - b.z();
    return x * x + y * y + z * z;
}

/// A kd-tree over points that come to rest: pairs of them are replaced by one point between them. The search stays
/// exact as boxes grow with what moves into them; once half of the points are gone the tree is built anew.
class CentroidTree {
  public:
    struct Found {
        std::uint32_t id = 0;
        double squaredDistance = 0.0;
    };

    /// The points get the ids 0, 1, ….
    explicit CentroidTree(std::span<const Eigen::Vector3d> points);

    bool isActive(std::uint32_t id) const { return leafOf_[id] != kNowhere; }
    const Eigen::Vector3d& point(std::uint32_t id) const { return points_[id]; }

    /// Moves `kept` to `position` and removes `removed`.
    void merge(std::uint32_t kept, std::uint32_t removed, const Eigen::Vector3d& position);

    /// @return the nearest other active point at most that far away; of several at the same distance the least id
    std::optional<Found> nearestOther(std::uint32_t id, double largestSquaredDistance) const;

  private:
    static constexpr std::uint32_t kNowhere = std::numeric_limits<std::uint32_t>::max();

    struct Node {
        Eigen::Vector3d low = Eigen::Vector3d::Zero();
        Eigen::Vector3d high = Eigen::Vector3d::Zero();
        std::uint32_t parent = kNowhere;
        /// kNowhere for a leaf; the second child is the next node.
        std::uint32_t firstChild = kNowhere;
        std::vector<std::uint32_t> ids;
    };

    void build();
    void divide(std::uint32_t node, std::span<std::uint32_t> ids);
    void search(std::uint32_t node, std::uint32_t id, Found& best) const;
    double boxDistance(const Node& node, const Eigen::Vector3d& point) const;

    std::vector<Eigen::Vector3d> points_;
    std::vector<std::uint32_t> leafOf_;
    std::vector<Node> nodes_;
    std::size_t active_ = 0;
    std::size_t activeWhenBuilt_ = 0;
};

}  // namespace fodscope
