// SPDX-License-Identifier: MIT
#include "app/cli/ConsoleProgress.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>

namespace fodscope::cli {
namespace {

using Clock = std::chrono::steady_clock;

bool errorIsTerminal() {
    return isatty(STDERR_FILENO) == 1;
}

}  // namespace

Progress::Observer consoleProgress() {
    if (!errorIsTerminal()) return {};
    return
        [shown = Clock::time_point(), shownStage = std::string()](const std::string& stage, double fraction) mutable {
            constexpr auto kInterval = std::chrono::milliseconds(100);
            const Clock::time_point now = Clock::now();
            if (stage == shownStage && now - shown < kInterval) return;
            shown = now;
            shownStage = stage;
            const int percent = static_cast<int>(100.0 * std::clamp(fraction, 0.0, 1.0));
            std::fprintf(stderr, "\r\033[K%3d %%  %s", percent, stage.c_str());
            std::fflush(stderr);
        };
}

void clearProgressLine() {
    if (!errorIsTerminal()) return;
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
}

}  // namespace fodscope::cli
