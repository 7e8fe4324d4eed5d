// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/detection/ClusterGrid.h"
#include "core/detection/HierarchicalClustering.h"

namespace fodscope {

/// Points at the same place are merged at distance 0 before anything else and their centroid does not move, so they
/// may start as one cluster with a count. Places are in the order of their first points, which are their ids.
struct Places {
    std::vector<LivingCluster> clusters;
    /// Those that make the places, in order.
    std::vector<Merge> merges;
};

/// @throws Error when a point is not finite
void requireFinite(std::span<const Eigen::Vector3d> points);

Places placesOf(std::span<const Eigen::Vector3d> points);

}  // namespace fodscope
