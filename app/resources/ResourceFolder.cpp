// SPDX-License-Identifier: MIT
#include "app/resources/ResourceFolder.h"

#include <cstdlib>
#include <system_error>

#include "core/common/Error.h"

namespace fodscope {

std::filesystem::path resourceFolder() {
    if (const char* given = std::getenv("FODSCOPE_RESOURCES"); given != nullptr && *given != '\0') return given;
    std::error_code code;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", code);
    const std::filesystem::path folder = program.parent_path().parent_path() / "share" / "fodscope";
    if (code || !std::filesystem::is_directory(folder)) {
        throw Error(folder.string(), "Fodscope's resources are not there",
                    "install Fodscope anew, or set FODSCOPE_RESOURCES to their folder");
    }
    return folder;
}

}  // namespace fodscope
