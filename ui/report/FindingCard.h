// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "ui/report/PageFlow.h"
#include "ui/report/ReportDocument.h"

namespace fodscope::report {

/// A finding on half a page: photo with outline and boxes, place on the plan, measures, decisions. What has no room
/// there follows as lines.
Flow findingCard(const std::shared_ptr<const ReportContent>& content, const ReportCandidate& finding);

}  // namespace fodscope::report
