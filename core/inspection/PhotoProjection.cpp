// SPDX-License-Identifier: MIT
#include "core/inspection/PhotoProjection.h"

#include <algorithm>

#include "core/common/ConvexHull.h"
#include "core/inspection/InspectionState.h"

namespace fodscope {
namespace {

/// Nearer points would project to anywhere.
constexpr double kNearestDepth_m = 0.02;

}  // namespace

std::vector<Eigen::Vector2d> projectPoints(std::span<const Eigen::Vector3d> points_map,
                                           const Transform& T_map_from_camera, const CameraIntrinsics& intrinsics) {
    const Transform T_camera_from_map = T_map_from_camera.inverse();
    std::vector<Eigen::Vector2d> points_px;
    points_px.reserve(points_map.size());
    for (const Eigen::Vector3d& point_map : points_map) {
        const Eigen::Vector3d point_camera = T_camera_from_map * point_map;
        if (point_camera.z() > kNearestDepth_m) points_px.push_back(pixelOf(point_camera, intrinsics));
    }
    return points_px;
}

ProjectedVoxels projectVoxels(std::span<const Eigen::Vector3d> voxels_map, double voxelSize_m,
                              const Transform& T_map_from_camera, const CameraIntrinsics& intrinsics) {
    ProjectedVoxels projected;
    const Transform T_camera_from_map = T_map_from_camera.inverse();
    const double half_m = voxelSize_m / 2.0;
    std::vector<Eigen::Vector2d> corners_px;
    corners_px.reserve(8 * voxels_map.size());
    for (const Eigen::Vector3d& voxel : voxels_map) {
        for (int corner = 0; corner < 8; ++corner) {
            const Eigen::Vector3d step((corner & 1) ? half_m : -half_m, (corner & 2) ? half_m : -half_m,
                                       (corner & 4) ? half_m : -half_m);
            const Eigen::Vector3d corner_camera = T_camera_from_map * (voxel + step);
            if (!(corner_camera.z() > kNearestDepth_m)) continue;
            projected.nearestDepth_m = std::min(projected.nearestDepth_m, corner_camera.z());
            corners_px.push_back(pixelOf(corner_camera, intrinsics));
        }
    }
    projected.hull_px = convexHull(std::move(corners_px));
    return projected;
}

bool isInPhoto(const Eigen::Vector3d& point_map, const Transform& T_map_from_camera,
               const CameraIntrinsics& intrinsics) {
    const Eigen::Vector3d point_camera = T_map_from_camera.inverse() * point_map;
    return point_camera.z() > kNearestDepth_m && isInImage(pixelOf(point_camera, intrinsics), intrinsics);
}

std::vector<Eigen::Vector3d> voxelsInMap(const Candidate& candidate, const DetectionRecord& detection) {
    std::vector<Eigen::Vector3d> voxels_map;
    if (!detection.field) return voxels_map;
    const Transform T_map_from_reference = detection.registration.T_reference_from_map.inverse();
    voxels_map.reserve(candidate.voxels.size());
    for (const std::uint32_t voxel : candidate.voxels) {
        if (voxel < detection.field->points.size())
            voxels_map.push_back(T_map_from_reference * detection.field->points[voxel]);
    }
    return voxels_map;
}

}  // namespace fodscope
