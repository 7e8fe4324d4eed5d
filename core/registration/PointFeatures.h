// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "core/common/Progress.h"

namespace fodscope {

/// Fast point feature histogram: how the surface bends round a point, whatever the pose of the cloud.
using PointFeature = std::array<float, 33>;

/// The feature of every point (PCL's normals and FPFH). Normals are turned to the middle of the cloud, as a tank is
/// mapped from within.
std::vector<PointFeature> pointFeatures(std::span<const Eigen::Vector3d> points, double normalRadius_m,
                                        double featureRadius_m, Progress& progress);

}  // namespace fodscope
