// SPDX-License-Identifier: MIT
#pragma once

namespace fodscope::bridge {

/// Speaks with the workstation until it goes away.
/// @return the program's exit code
int runBridge(int input, int output);

}  // namespace fodscope::bridge
