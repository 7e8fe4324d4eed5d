// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <iosfwd>
#include <stdexcept>

#include "core/common/Progress.h"

namespace CLI {
class App;
}

namespace fodscope::cli {

/// What a command works with besides its options.
struct Context {
    Progress& progress;
    /// For what was asked for.
    std::ostream& out;
    /// For remarks about the input.
    std::ostream& remarks;
};

/// The command that the user named, with its options, ready to run.
using Run = std::function<void(Context&)>;

/// The options contradict each other or are out of range: exit code 2.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace fodscope::cli
