// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <QPolygonF>
#include <span>
#include <string>
#include <vector>

#include "core/inspection/InspectionState.h"
#include "core/robot/Photo.h"

namespace fodscope {

/// Where a candidate lies in a photo, in pixels of the photo as received.
struct CandidateOutline {
    std::string candidateId;
    QPolygonF polygon_px;
};

/// Outline of voxels in a photo: the hull of the projected voxel cubes, grown by `halo_px` for the doubt in pose and
/// calibration, clipped to the image. Empty when nothing of them lies in the image.
QPolygonF projectedOutline(std::span<const Eigen::Vector3d> voxels_map, double voxelSize_m,
                           const Transform& T_map_from_camera, const CameraIntrinsics& intrinsics,
                           double halo_px = 12.0);

/// Outlines of the candidates that a photo was taken for.
std::vector<CandidateOutline> candidateOutlines(const DetectionRecord& detection, const Photo& photo);

}  // namespace fodscope
