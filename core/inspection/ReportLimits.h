// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/inspection/InspectionState.h"

namespace fodscope {

/// What the inspection cannot say, one sentence each.
std::vector<std::string> limitsOf(const InspectionState& state);

/// What stands between a draft and a report that can be issued, one sentence each.
std::vector<std::string> missingForIssue(const InspectionState& state);

}  // namespace fodscope
