// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace fodscope {

/// Where label sets, default parameters and the manual lie: share/fodscope beside the program's folder, installed as
/// well as in the build tree; the environment variable FODSCOPE_RESOURCES goes first.
/// @throws Error when it is in none of these places
std::filesystem::path resourceFolder();

}  // namespace fodscope
