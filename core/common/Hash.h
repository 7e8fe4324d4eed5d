// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace fodscope {

/// @return SHA-256 in 64 lower-case hexadecimal digits
std::string sha256(std::span<const std::byte> bytes);
std::string sha256(std::string_view text);

/// @throws Error when the file cannot be read
std::string sha256OfFile(const std::filesystem::path& file);

}  // namespace fodscope
