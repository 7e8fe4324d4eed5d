// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/cloud/ByteWindow.h"
#include "core/cloud/Ply.h"
#include "core/cloud/PointCloud.h"
#include "core/common/Error.h"

namespace fodscope {

Error noPlyCoordinates(const std::string& subject);

/// @return the vertices' coordinates, also those that are not finite
/// @throws Error when the properties x, y, z are not all there
std::vector<Eigen::Vector3d> plyPoints(const PlyContents& contents, const std::string& subject);

/// @return the properties red, green, blue; empty when they are not all there
std::vector<Rgb> plyColours(const PlyContents& contents);

/// Reads the vertices alone, without keeping more of the file than that.
/// @param window the file from its begin
/// @return the points with finite coordinates; their number may be 0
/// @throws Error as parsePly() does, and when the properties x, y, z are not all there
PointCloud readPlyCloud(ByteWindow& window, const std::string& subject);

/// @return x y z as float and, where there are any, red green blue as uchar
std::vector<PlyColumn> plyColumns(std::span<const Eigen::Vector3d> points, std::span<const Rgb> colours = {});

}  // namespace fodscope
