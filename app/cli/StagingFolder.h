// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace fodscope::cli {

/// A hidden folder inside the one that results go to. What was written there moves out by publish(), all of it at the
/// end; without that nothing stays.
class StagingFolder {
  public:
    /// @throws Error when it cannot be made
    explicit StagingFolder(const std::filesystem::path& destination);
    ~StagingFolder();
    StagingFolder(const StagingFolder&) = delete;
    StagingFolder& operator=(const StagingFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

    /// @throws Error when a file cannot take its place
    void publish();

  private:
    std::filesystem::path destination_;
    std::filesystem::path path_;
};

}  // namespace fodscope::cli
