// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>

#include "core/cloud/PointCloud.h"

namespace fodscope {

struct VoxelGridSettings {
    /// Edge of a voxel. The paper: 0.05 m for the reference, 0.02 m for the query.
    double voxelSize_m = 0.02;

    bool operator==(const VoxelGridSettings&) const = default;
};

/// Mean and count of the points in each voxel; a point's voxel is floor((p − origin) / size) on each axis, in double.
/// Paper: "Discrepancy Query" (voxel down-sampling whose counts n_i are kept as weights).
/// @param origin corner of the lattice, in the frame of the points
/// @throws Error when the size is not positive, or the extent of the points has more than 2^21 voxels on an axis
VoxelCloud voxelGrid(std::span<const Eigen::Vector3d> points, const Eigen::Vector3d& origin,
                     const VoxelGridSettings& settings);

/// @return the least coordinate on each axis
/// @throws Error when there are no points
Eigen::Vector3d minimumCorner(std::span<const Eigen::Vector3d> points);
Eigen::Vector3d maximumCorner(std::span<const Eigen::Vector3d> points);

}  // namespace fodscope
