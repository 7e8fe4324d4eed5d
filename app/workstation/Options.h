// SPDX-License-Identifier: MIT
#pragma once

#include <QSize>
#include <optional>
#include <string>

#include "ui/theme/Theme.h"

namespace fodscope {

/// What the workstation is started with.
struct Options {
    std::string session;
    bool demo = false;
    bool autopilot = false;
    std::string screenshots;
    std::optional<QSize> size;
    std::optional<ThemeKind> theme;
};

/// What came of reading the command line: options, or the code to end with (help, version, wrong usage).
struct ParsedOptions {
    Options options;
    std::optional<int> exitCode;
};

ParsedOptions parseOptions(int argc, char** argv);

}  // namespace fodscope
