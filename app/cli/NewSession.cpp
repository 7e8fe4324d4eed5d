// SPDX-License-Identifier: MIT
#include "app/cli/NewSession.h"

#include <system_error>
#include <utility>

#include "core/common/Error.h"

namespace fodscope::cli {

void requireNoSession(const std::filesystem::path& file) {
    std::error_code code;
    if (!std::filesystem::exists(file, code)) return;
    throw Error(file.string(), "is there already, and a session is never overwritten", "choose another name");
}

NewSession::NewSession(std::filesystem::path file, const InspectionHeader& header)
    : path_(std::move(file)), session_(SessionFile::create(path_, header)) {}

NewSession::~NewSession() {
    session_.reset();
    if (kept_) return;
    // SQLite keeps a log and shared memory beside a database that was not closed in peace.
    for (const char* suffix : {"", "-wal", "-shm"}) {
        std::error_code code;
        std::filesystem::remove(path_.string() + suffix, code);
    }
}

}  // namespace fodscope::cli
