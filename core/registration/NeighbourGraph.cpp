// SPDX-License-Identifier: MIT
#include "core/registration/NeighbourGraph.h"

#include <algorithm>
#include <limits>

#include "core/registration/OrderedSum.h"

namespace fodscope {
namespace {

/// Far more than the rounding of distances, in float too.
constexpr double kRounding = 1e-6;

/// With NeighbourIndex's operations in its order, for its bits.
double squaredDistance_m2(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const double x = a.x() - b.x();
    const double y = a.y() - b.y();
    const double z = a.z() - b.z();
    return x * x + y * y + z * z;
}

}  // namespace

NeighbourGraph::NeighbourGraph(std::span<const Eigen::Vector3d> points, Progress& progress)
    : points_(points), index_(points), links_(points.size()) {
    index_.forEachKNearest(
        points_, kLinks + 1,
        [&](std::size_t i, std::span<const Neighbour> found) {
            Links& links = links_[i];
            links.halfLength_m2.fill(std::numeric_limits<float>::infinity());
            std::size_t count = 0;
            for (const Neighbour& neighbour : found) {
                if (neighbour.index == i || count == kLinks) continue;
                links.to[count] = neighbour.index;
                links.halfLength_m2[count++] =
                    static_cast<float>(neighbour.squaredDistance_m2 / 4.0 * (1.0 - kRounding));
            }
        },
        progress);
}

Neighbour NeighbourGraph::nearest(const Eigen::Vector3d& query, std::uint32_t hint) const {
    Neighbour best{hint, squaredDistance_m2(points_[hint], query)};
    const std::size_t count = std::min(kLinks, points_.size() - 1);
    for (std::size_t link = 0; link < count;) {
        const Links& links = links_[best.index];
        if (best.squaredDistance_m2 < links.halfLength_m2[link]) return best;
        const std::uint32_t to = links.to[link++];
        const double distance_m2 = squaredDistance_m2(points_[to], query);
        if (distance_m2 > best.squaredDistance_m2) continue;
        if (distance_m2 == best.squaredDistance_m2 && to > best.index) continue;
        best = {to, distance_m2};
        link = 0;
    }
    return count < kLinks || points_.size() == kLinks + 1 ? best : index_.nearest(query);
}

void NeighbourGraph::update(std::span<const Eigen::Vector3d> queries, std::vector<Neighbour>& nearest,
                            Progress& progress) const {
    const bool isFirst = nearest.size() != queries.size();
    nearest.resize(queries.size());
    forEachPart(queries.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
        progress.throwIfCancelled();
        if (isFirst) nearest[begin] = index_.nearest(queries[begin]);
        for (std::size_t i = begin; i < end; ++i)
            nearest[i] = this->nearest(queries[i], nearest[isFirst && i > begin ? i - 1 : i].index);
    });
}

}  // namespace fodscope
