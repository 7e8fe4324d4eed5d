// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <utility>

#include "core/common/Error.h"

namespace fodscope {

/// How a long stage tells where it is and learns that it should stop. One object accompanies one run.
/// report() and throwIfCancelled() may be called from any thread; the observer is called on the caller's thread.
class Progress {
  public:
    /// Stage in words ("smoothing the discrepancy") and fraction of that stage in 0..1.
    using Observer = std::function<void(const std::string& stage, double fraction)>;

    Progress() = default;
    explicit Progress(Observer observer) : observer_(std::move(observer)) {}

    void report(const std::string& stage, double fraction) {
        throwIfCancelled();
        if (observer_) observer_(stage, fraction);
    }

    void cancel() { cancelled_ = true; }
    bool isCancelled() const { return cancelled_; }

    /// @throws Cancelled once cancel() was called
    void throwIfCancelled() const {
        if (cancelled_) throw Cancelled();
    }

  private:
    Observer observer_;
    std::atomic<bool> cancelled_{false};
};

}  // namespace fodscope
