// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "core/inspection/InspectionState.h"

namespace fodscope {

/// `discrepancy.ply` of the file contract: x y z in the reference frame, `weight` (points in the voxel), `euclidean`
/// (metres), `mahalanobis` (NaN where unknown), `discrepancy` (the smoothed one that is thresholded) and `candidate`
/// (its number, −1 none). CloudCompare shows them as scalar fields.
/// @throws Error when it cannot be written, or the detection has no candidates to tell (a bad alignment)
void writeDiscrepancyPly(const std::filesystem::path& file, const DetectionRecord& detection);

/// The voxels of such a file with a discrepancy above a threshold.
/// @throws Error when the file is none such
std::vector<Eigen::Vector3d> readDiscrepantPoints_reference(const std::filesystem::path& file, double threshold);

}  // namespace fodscope
