// SPDX-License-Identifier: MIT
#pragma once

#include "core/common/Progress.h"

namespace fodscope::cli {

/// @return an observer that keeps one line on standard error up to date; one that does nothing when that is no terminal
Progress::Observer consoleProgress();

/// Removes that line, so that what follows starts on a clean one.
void clearProgressLine();

}  // namespace fodscope::cli
