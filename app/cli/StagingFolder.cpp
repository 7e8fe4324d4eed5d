// SPDX-License-Identifier: MIT
#include "app/cli/StagingFolder.h"

#include <cstdlib>
#include <string>
#include <system_error>
#include <vector>

#include "core/common/Error.h"
#include "core/common/Files.h"

namespace fodscope::cli {

StagingFolder::StagingFolder(const std::filesystem::path& destination) : destination_(destination) {
    std::string pattern = (destination / ".fodscope-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) {
        throw Error(destination.string(), "cannot be written to", "check that it may be written and the disk has room");
    }
    path_ = pattern;
}

StagingFolder::~StagingFolder() {
    std::error_code code;
    std::filesystem::remove_all(path_, code);
}

void StagingFolder::publish() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path_)) {
        if (entry.is_regular_file()) files.push_back(std::filesystem::relative(entry.path(), path_));
    }
    for (const std::filesystem::path& file : files) {
        makeFolder((destination_ / file).parent_path());
        std::error_code code;
        std::filesystem::rename(path_ / file, destination_ / file, code);
        if (code) {
            throw Error((destination_ / file).string(), "cannot be written (" + code.message() + ")",
                        "check what is in the way");
        }
    }
}

}  // namespace fodscope::cli
