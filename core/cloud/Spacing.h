// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>

#include "core/common/Progress.h"

namespace fodscope {

/// How dense a cloud is: the median distance from a point to the nearest other point, in metres. At most 20 000 evenly
/// chosen points are asked, all are searched.
/// @throws Error when there are fewer than two points
double medianSpacing_m(std::span<const Eigen::Vector3d> points, Progress& progress);

}  // namespace fodscope
