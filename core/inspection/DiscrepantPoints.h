// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

namespace fodscope {

struct DiscrepantVoxel {
    Eigen::Vector3d point_reference = Eigen::Vector3d::Zero();
    /// The number in the id of its candidate, −1 for none.
    int candidate = -1;
};

/// The voxels of a `discrepancy.ply` (see core/detection/DiscrepancyPly.h) whose discrepancy is above a threshold.
/// @throws Error when the file is none such
std::vector<DiscrepantVoxel> readDiscrepantVoxels(const std::filesystem::path& file, double threshold);

}  // namespace fodscope
