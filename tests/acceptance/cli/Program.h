// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace fodscope::test {

/// What a run of the program left behind.
struct Outcome {
    /// −1 when it was ended by a signal.
    int exitCode = -1;
    std::string out;
    std::string err;
};

/// A folder of its own for one test, gone with it.
class TestFolder {
  public:
    TestFolder();
    ~TestFolder();
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// fodscope-cli under way. Standard output and error are no terminals.
class Program {
  public:
    explicit Program(const std::vector<std::string>& arguments);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void interrupt() const;
    /// @return whether an interrupt no longer ends the program by itself
    bool hearsInterrupts() const;
    bool isRunning();
    Outcome wait();

  private:
    pid_t process_ = -1;
    int status_ = 0;
    bool ended_ = false;
    TestFolder folder_;
};

/// Runs fodscope-cli to its end.
Outcome runCli(const std::vector<std::string>& arguments);

}  // namespace fodscope::test
