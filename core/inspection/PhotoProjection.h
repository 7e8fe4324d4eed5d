// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <limits>
#include <span>
#include <vector>

#include "core/common/Geometry.h"
#include "core/detection/Candidates.h"
#include "core/robot/Photo.h"

namespace fodscope {

struct DetectionRecord;

/// Pinhole projection, pixels of the photo as received; points at or behind the camera are left out, points beside the
/// image are kept.
std::vector<Eigen::Vector2d> projectPoints(std::span<const Eigen::Vector3d> points_map,
                                           const Transform& T_map_from_camera, const CameraIntrinsics& intrinsics);

/// Where voxels lie in a photo.
struct ProjectedVoxels {
    /// Hull of the projected voxel cubes, not clipped to the image; fewer than three points: not in front of the
    /// camera.
    std::vector<Eigen::Vector2d> hull_px;
    /// Depth of the nearest corner in front of the camera; infinite without one.
    double nearestDepth_m = std::numeric_limits<double>::infinity();
};

ProjectedVoxels projectVoxels(std::span<const Eigen::Vector3d> voxels_map, double voxelSize_m,
                              const Transform& T_map_from_camera, const CameraIntrinsics& intrinsics);

/// Whether a point lies before the camera and projects into the photo.
bool isInPhoto(const Eigen::Vector3d& point_map, const Transform& T_map_from_camera,
               const CameraIntrinsics& intrinsics);

/// @return the voxels of a candidate in the map frame; none without a field
std::vector<Eigen::Vector3d> voxelsInMap(const Candidate& candidate, const DetectionRecord& detection);

}  // namespace fodscope
