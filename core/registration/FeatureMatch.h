// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/common/Geometry.h"
#include "core/common/Progress.h"

namespace fodscope {

/// Coarse alignments of two clouds of about equal voxels without a start pose: fast point feature histograms (PCL) are
/// matched, and seeded random triples of matches proposed and counted. Both frames have z up (REP 103), so motions that
/// tip the map over are not proposed. Deterministic.
/// Source: Rusu et al. 2009 (FPFH); Buch et al. 2013 (rejection of triples by the lengths of their edges).
/// @return motions T_target_from_source, the one with most agreeing matches first; empty when nothing matches
std::vector<Transform> matchFeatures(std::span<const Eigen::Vector3d> source, std::span<const Eigen::Vector3d> target,
                                     double voxelSize_m, Progress& progress);

}  // namespace fodscope
