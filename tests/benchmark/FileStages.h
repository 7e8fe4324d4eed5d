// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace fodscope {

/// Reads a cloud.
/// @return its points
double readPoints(const std::filesystem::path& cloud);

/// From files to candidates, as `fodscope-cli detect` does it without its output: the map lies in the reference's frame
/// already, or is registered.
/// @return the voxels above the threshold
double discrepantVoxels(const std::filesystem::path& map, const std::filesystem::path& reference, bool isAligned);

}  // namespace fodscope
