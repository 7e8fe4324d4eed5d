// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

namespace fodscope {

/// The voxels of a `discrepancy.ply` (see core/detection/DiscrepancyPly.h) whose discrepancy is above a threshold,
/// reference frame.
/// @throws Error when the file is none such
std::vector<Eigen::Vector3d> readDiscrepantPoints_reference(const std::filesystem::path& file, double threshold);

}  // namespace fodscope
