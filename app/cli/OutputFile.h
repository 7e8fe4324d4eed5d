// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace fodscope::cli {

/// For a file that is written at the end of long work: says at the beginning when that cannot succeed.
/// @throws Error when its folder is missing or it is itself a folder
void requireWritable(const std::filesystem::path& file);

}  // namespace fodscope::cli
