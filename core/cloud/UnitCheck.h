// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>

#include "core/cloud/PointCloud.h"
#include "core/cloud/TriangleMesh.h"

namespace fodscope {

/// No tank is longer than this; a cloud that is, is not in metres.
inline constexpr double kLargestExtent_m = 200.0;

/// A cloud with fewer points shows no shape: nothing can be aligned with it or found in it.
inline constexpr std::size_t kFewestPoints = 10;

/// Whoever loads a cloud as a map or reference calls this after reading it.
/// @param subject the file's name, for the error
/// @throws Error when there are too few points to compare, or when the extent shows that they are not in metres
void requireUsableCloud(std::span<const Eigen::Vector3d> points, const std::string& subject);

/// The same for a mesh: only the unit is judged.
void requireMetres(const TriangleMesh& mesh, const std::string& subject);

}  // namespace fodscope
