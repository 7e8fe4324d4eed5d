// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fodscope {

/// Reads a whole file.
/// @throws Error when it is missing, a folder, or cannot be read to its end
std::vector<std::byte> readFile(const std::filesystem::path& file);
std::string readTextFile(const std::filesystem::path& file);

/// Writes a whole file so that a reader sees either the old content or the new one: the bytes go to a temporary file
/// beside it, are flushed to the disk, and take its name by rename.
/// @throws Error when the folder is missing, may not be written or the disk is full; the old file is then untouched
void writeFile(const std::filesystem::path& file, std::span<const std::byte> bytes);
void writeFile(const std::filesystem::path& file, std::string_view text);

/// Makes a folder and its parents.
/// @throws Error when that is not possible
void makeFolder(const std::filesystem::path& folder);

}  // namespace fodscope
