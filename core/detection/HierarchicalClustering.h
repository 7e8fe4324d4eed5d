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
///
/// Merging stops at the first closest pair beyond the cutoff, and that is what fcluster means although centroid linkage
/// is not monotone (a merged centroid can be closer to a third cluster than the merged two were to each other).
/// fcluster joins a node's points when no merge below it, the node included, is beyond the cutoff. All merges before
/// the stop are within it, so the clusters at the stop are joined. No later merge joins more: at the stop all living
/// pairs are beyond the cutoff, and a merge of two of those clusters keeps its distance; any other merge within the
/// cutoff involves a cluster made after the stop, and by induction every such cluster has a merge beyond the cutoff
/// below it.
///
/// Points at the same place merge first, at distance 0.
/// @return a label per point; labels are numbered from 0 by each cluster's first point
/// @throws Error when the cutoff is negative or not finite; Cancelled
std::vector<std::uint32_t> centroidLinkageClusters(std::span<const Eigen::Vector3d> points, double cutoff_m,
                                                   Progress& progress);

}  // namespace fodscope
