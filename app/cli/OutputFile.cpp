// SPDX-License-Identifier: MIT
#include "app/cli/OutputFile.h"

#include <unistd.h>

#include <system_error>

#include "core/common/Error.h"

namespace fodscope::cli {

void requireWritable(const std::filesystem::path& file) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
        throw Error(file.string(), "is a folder", "give the name of a file to write to");
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    if (!std::filesystem::is_directory(folder, ignored))
        throw Error(file.string(), "cannot be written, its folder does not exist", "make the folder first");
    if (::access(folder.c_str(), W_OK) != 0)
        throw Error(file.string(), "cannot be written, its folder may not be written to",
                    "choose another folder or change its permissions");
}

}  // namespace fodscope::cli
