// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/common/Progress.h"

namespace fodscope {

/// Agglomerative clustering with centroid linkage: the definition of scipy's
/// `fcluster(linkage(X, 'centroid'), cutoff, 'distance')`. Every point counts 1. Clusters whose centroids are at most
/// `cutoff_m` apart are merged, closest pair first; ties go to the pair with the lower first-point index.
/// Exact, in memory that grows with n (only pairs within the cutoff matter).
/// @return a label per point; labels are numbered from 0 by each cluster's first point
/// @throws Error when the cutoff is negative or not finite; Cancelled
std::vector<std::uint32_t> centroidLinkageClusters(std::span<const Eigen::Vector3d> points, double cutoff_m,
                                                   Progress& progress);

}  // namespace fodscope
