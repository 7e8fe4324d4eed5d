// SPDX-License-Identifier: MIT
#include "app/cli/Interrupt.h"

#include <pthread.h>

namespace fodscope::cli {
namespace {

sigset_t interruptSignals() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    return signals;
}

void blockInterrupts() {
    const sigset_t signals = interruptSignals();
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

/// Runs before the constructors of the libraries, which take longer than main() needs to begin: who interrupts
/// meanwhile is heard as soon as an Interrupt waits.
[[gnu::section(".preinit_array"), gnu::used]] void (*const kBlockInterruptsFirst)() = blockInterrupts;

}  // namespace

Interrupt::Interrupt(Progress& progress) : signals_(interruptSignals()) {
    blockInterrupts();
    waiter_ = std::thread([this, &progress] { wait(progress); });
}

Interrupt::~Interrupt() {
    done_ = true;
    // To this thread alone, to end its wait.
    pthread_kill(waiter_.native_handle(), SIGTERM);
    waiter_.join();
}

void Interrupt::wait(Progress& progress) {
    bool asked = false;
    for (int signal = 0; sigwait(&signals_, &signal) == 0 && !done_;) {
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
