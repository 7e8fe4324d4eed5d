// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "ui/report/PageFlow.h"
#include "ui/report/ReportDocument.h"

namespace fodscope::report {

/// The parts of a report in their order, as flows of what they consist of.
Flow titleSection(const ReportContent& content);
/// Stands with the statement, which is not to be read without it.
Flow limitsSection(const ReportContent& content);
Flow planSection(const std::shared_ptr<const ReportContent>& content);
Flow findingsSection(const std::shared_ptr<const ReportContent>& content);
Flow otherCandidatesSection(const ReportContent& content);
Flow groundsSection(const ReportContent& content);

}  // namespace fodscope::report
