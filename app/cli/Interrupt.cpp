// SPDX-License-Identifier: MIT
#include "app/cli/Interrupt.h"

#include <ctime>

namespace fodscope::cli {

Interrupt::Interrupt(Progress& progress) {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGINT);
    sigaddset(&signals_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
    waiter_ = std::thread([this, &progress] { wait(progress); });
}

Interrupt::~Interrupt() {
    done_ = true;
    waiter_.join();
}

void Interrupt::wait(Progress& progress) {
    constexpr timespec kShortWait{0, 50'000'000};
    bool asked = false;
    while (!done_) {
        if (sigtimedwait(&signals_, nullptr, &kShortWait) <= 0) continue;
        if (asked) {
            // Who asks twice does not want to wait for the stage to notice.
            pthread_sigmask(SIG_UNBLOCK, &signals_, nullptr);
            std::raise(SIGTERM);
        }
        asked = true;
        progress.cancel();
    }
}

}  // namespace fodscope::cli
