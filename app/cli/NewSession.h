// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "storage/SessionFile.h"

namespace fodscope::cli {

/// @throws Error when there is a session of that name already, which is never overwritten
void requireNoSession(const std::filesystem::path& file);

/// A session file under way: it is taken away again unless it was finished.
class NewSession {
  public:
    /// @throws Error as SessionFile::create()
    NewSession(std::filesystem::path file, const InspectionHeader& header);
    ~NewSession();
    NewSession(const NewSession&) = delete;
    NewSession& operator=(const NewSession&) = delete;

    SessionFile& file() { return *session_; }
    void keep() { kept_ = true; }

  private:
    std::filesystem::path path_;
    std::unique_ptr<SessionFile> session_;
    bool kept_ = false;
};

}  // namespace fodscope::cli
