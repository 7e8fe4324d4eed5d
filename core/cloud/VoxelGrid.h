// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>

#include "core/cloud/Bounds.h"
#include "core/cloud/MovedPoints.h"
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

/// The same of a moved and cropped cloud, on a lattice that starts at the least coordinates of what is left of it.
/// @return no voxels when the crop leaves no points
VoxelCloud voxelGrid(const MovedPoints& points, const VoxelGridSettings& settings);

}  // namespace fodscope
