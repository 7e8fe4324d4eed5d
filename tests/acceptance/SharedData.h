// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <filesystem>

namespace fodscope {

/// @return the folder with the real tanks' data, which is not part of the source; it may not exist
inline std::filesystem::path sharedData() {
    if (const char* folder = std::getenv("FODSCOPE_SHARED_DATA")) return folder;
    return (std::filesystem::path(FODSCOPE_TEST_DATA) / "../../../shared/data").lexically_normal();
}

}  // namespace fodscope
