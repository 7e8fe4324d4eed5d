// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/cloud/Ply.h"
#include "core/cloud/PointCloud.h"

namespace fodscope {

/// @return the vertices' coordinates, also those that are not finite
/// @throws Error when the properties x, y, z are not all there
std::vector<Eigen::Vector3d> plyPoints(const PlyContents& contents, const std::string& subject);

/// @return the properties red, green, blue; empty when they are not all there
std::vector<Rgb> plyColours(const PlyContents& contents);

/// @return the points with finite coordinates; their number may be 0
PointCloud cloudFromPly(const PlyContents& contents, const std::string& subject);

/// @return x y z as float and, where there are any, red green blue as uchar
std::vector<PlyColumn> plyColumns(std::span<const Eigen::Vector3d> points, std::span<const Rgb> colours = {});

}  // namespace fodscope
