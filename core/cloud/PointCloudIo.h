// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "core/cloud/PointCloud.h"
#include "core/common/Progress.h"

namespace fodscope {

enum class PcdEncoding { Ascii, Binary, BinaryCompressed };

/// Reads a point cloud, by its content: PCD v0.5 to v0.7 (ascii, binary, binary_compressed) or PLY (ascii, binary of
/// either byte order; faces are ignored). Any field order and padding; x, y, z of any numeric type; colour from a PCD
/// field `rgb` or `rgba`, or from the PLY properties red, green, blue. Points with a coordinate that is not finite are
/// dropped and counted.
/// Source: PCL's "The PCD file format", Turk's PLY.
/// @throws Error for a file that is missing, empty, truncated, no cloud, without x y z, or has no finite point; sizes
/// in
///         the header are checked against the file before anything is allocated
PointCloud readPointCloud(const std::filesystem::path& file);

/// The same with progress.
/// @throws Cancelled
PointCloud readPointCloud(const std::filesystem::path& file, Progress& progress,
                          const std::string& stage = "reading the cloud");

/// Writes by the extension: .pcd (binary_compressed unless told otherwise) or .ply (binary little endian). Coordinates
/// are stored as float32.
/// @throws Error when the file cannot be written or the extension is neither
void writePointCloud(const std::filesystem::path& file, const PointCloud& cloud,
                     PcdEncoding encoding = PcdEncoding::BinaryCompressed);

}  // namespace fodscope
