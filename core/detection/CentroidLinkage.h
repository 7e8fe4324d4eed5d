// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/common/Progress.h"
#include "core/detection/HierarchicalClustering.h"

namespace fodscope {

/// The merges of centroid linkage up to a cutoff, in order; see mergeSequence().
/// @param places points, no two of them the same, each with the number of points that it stands for
std::vector<Merge> centroidMerges(std::span<const Eigen::Vector3d> places, std::span<const double> weights,
                                  double cutoff_m, Progress& progress);

}  // namespace fodscope
