// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <csignal>
#include <thread>

#include "core/common/Progress.h"

namespace fodscope::cli {

/// Turns SIGINT and SIGTERM into a cancelled Progress. Make it before any other thread starts: threads inherit that the
/// signals are blocked, and one thread of its own waits for them.
class Interrupt {
  public:
    explicit Interrupt(Progress& progress);
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

  private:
    void wait(Progress& progress);

    sigset_t signals_{};
    std::atomic<bool> done_{false};
    std::thread waiter_;
};

}  // namespace fodscope::cli
