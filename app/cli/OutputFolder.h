// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace fodscope::cli {

/// The folder that results go to. It is made at once, so that a bad place is told before the long work begins, and
/// taken away again when the work fails and it is still empty.
class OutputFolder {
  public:
    /// @throws Error when it cannot be made
    explicit OutputFolder(std::filesystem::path path);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
    bool made_ = false;
};

}  // namespace fodscope::cli
