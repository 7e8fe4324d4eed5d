// SPDX-License-Identifier: MIT
#pragma once

#include <mutex>
#include <string>
#include <thread>

#include "core/common/Progress.h"

namespace fodscope {

/// One progress for work that several threads share. It is reported from the thread that made it alone, since that is
/// where its observer expects to be called; cancelling it stops the work on all threads.
class SharedProgress {
  public:
    SharedProgress(Progress& whole, std::string stage, double work)
        : whole_(whole), stage_(std::move(stage)), work_(work) {}

    /// For one part of the work on any thread. What the part's own stages report only makes it look here.
    Progress forPart() {
        return Progress([this](const std::string&, double) { look(); });
    }

    void add(double done) {
        {
            const std::lock_guard lock(mutex_);
            done_ += done;
        }
        look();
    }

  private:
    void look() {
        if (std::this_thread::get_id() != caller_) return whole_.throwIfCancelled();
        double done = 0.0;
        {
            const std::lock_guard lock(mutex_);
            done = done_;
        }
        whole_.report(stage_, work_ > 0.0 ? done / work_ : 1.0);
    }

    Progress& whole_;
    const std::string stage_;
    const double work_;
    const std::thread::id caller_ = std::this_thread::get_id();
    std::mutex mutex_;
    double done_ = 0.0;
};

}  // namespace fodscope
