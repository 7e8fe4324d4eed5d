// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>

#include "ui/report/ReportDocument.h"

namespace fodscope::report {

/// One file that needs no other: style and pictures are inside, nothing is fetched, nothing runs.
QByteArray reportHtml(const ReportContent& content);

}  // namespace fodscope::report
