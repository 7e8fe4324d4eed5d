// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

namespace fodscope::bridge {

/// A program whose standard input and output are ours. Not for use from two threads.
class ChildProcess {
  public:
    /// @throws Error when it cannot be started
    explicit ChildProcess(const std::filesystem::path& program);
    /// Lets it end by itself for a second once its input is closed, then kills it.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Non-blocking.
    int input() const { return input_; }
    int output() const { return output_; }
    pid_t id() const { return id_; }
    void kill();
    /// Waits for its end. @return how it ended, in words
    std::string ending();

  private:
    bool reap(int milliseconds);

    pid_t id_ = -1;
    int input_ = -1;
    int output_ = -1;
    int status_ = 0;
    bool isReaped_ = false;
};

}  // namespace fodscope::bridge
