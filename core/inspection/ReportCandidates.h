// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/inspection/ReportModel.h"

namespace fodscope {

/// Every candidate as the report tells it, most suspicious first.
std::vector<ReportCandidate> reportCandidates(const InspectionState& state);

}  // namespace fodscope
