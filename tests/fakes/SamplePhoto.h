// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/robot/Photo.h"

namespace fodscope {

/// An upright block that stands in the sample's tank.
struct SampleBlock {
    Eigen::Vector3d minimum_map;
    Eigen::Vector3d maximum_map;
    unsigned colour = 0xff808080U;
};

/// 1280×720, 69° across.
CameraIntrinsics sampleIntrinsics();

/// Camera 0.2 m over the floor, 5° down, in front of a robot at `robot_map`.
Transform sampleCameraPose(const Pose2& robot_map);

/// A JPEG of blocks on a rusty floor, as the pinhole sees them.
std::vector<std::byte> samplePhoto(const std::vector<SampleBlock>& blocks, const Transform& T_map_from_camera,
                                   const CameraIntrinsics& intrinsics);

}  // namespace fodscope
