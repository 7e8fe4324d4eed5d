// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "core/cloud/ByteWindow.h"
#include "core/cloud/PointCloud.h"
#include "core/cloud/PointCloudIo.h"

namespace fodscope {

/// @return whether the bytes begin as a PCD file does
bool isPcd(std::span<const std::byte> bytes);

/// Source: PCL's "The PCD (Point Cloud Data) file format", v0.5 to v0.7.
/// @param window the file from its begin
/// @return the points with finite coordinates; their number may be 0
/// @throws Error when the header is malformed or the data is shorter than the header says, before allocating for it
PointCloud readPcd(ByteWindow& window, const std::string& subject);

/// @return the file's bytes, with x y z as float32 and, where the cloud has colours, rgb packed into a float32
std::string pcdBytes(const PointCloud& cloud, PcdEncoding encoding);

}  // namespace fodscope
