// SPDX-License-Identifier: MIT
#include "app/cli/OutputFolder.h"

#include <unistd.h>

#include <system_error>
#include <utility>

#include "core/common/Error.h"
#include "core/common/Files.h"

namespace fodscope::cli {

OutputFolder::OutputFolder(std::filesystem::path path) : path_(std::move(path)) {
    std::error_code code;
    made_ = !std::filesystem::exists(path_, code);
    makeFolder(path_);
    if (::access(path_.c_str(), W_OK) != 0) {
        throw Error(path_.string(), "the folder may not be written", "choose another folder");
    }
}

OutputFolder::~OutputFolder() {
    // remove() leaves a folder that holds something alone.
    std::error_code code;
    if (made_) std::filesystem::remove(path_, code);
}

}  // namespace fodscope::cli
