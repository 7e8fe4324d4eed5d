// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/common/Progress.h"
#include "core/detection/HierarchicalClustering.h"

namespace fodscope {

/// The merges of single linkage up to a cutoff, in order; see mergeSequence().
/// @param places points, no two of them the same
std::vector<Merge> singleMerges(std::span<const Eigen::Vector3d> places, double cutoff_m, Progress& progress);

}  // namespace fodscope
