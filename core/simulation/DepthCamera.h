// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/simulation/DepthMapping.h"
#include "core/simulation/Raycaster.h"

namespace fodscope {

/// One measured pixel, in the camera's optical frame.
struct DepthReturn {
    Eigen::Vector3f point_camera = Eigen::Vector3f::Zero();
    /// −1 is the structure; pixels that fly between two surfaces belong to it too.
    std::int32_t object = -1;
    Rgb colour;
};

/// A depth image as points: noise growing with z², steps of disparity, flying pixels at edges, dropouts at grazing
/// angles and out of range. The same seed gives the same image.
std::vector<DepthReturn> depthFrame(const Raycaster& raycaster, const Transform& T_world_from_camera,
                                    const DepthMappingSettings& settings, std::uint64_t frameSeed);

/// @return z as the camera tells it, from steps of disparity
double inDisparitySteps(double z_m, const DepthMappingSettings& settings);

}  // namespace fodscope
