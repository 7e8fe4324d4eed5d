// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <memory>

#include "ui/report/ReportDocument.h"

namespace fodscope::report {

/// A4, searchable text, fonts embedded.
QByteArray reportPdf(const std::shared_ptr<const ReportContent>& content);

}  // namespace fodscope::report
