// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QFont>
#include <QRectF>

#include "ui/theme/Theme.h"

namespace fodscope::report {

/// Everything on a page is laid out in tenths of a millimetre of A4.
inline constexpr double kPageWidth = 2100.0;
inline constexpr double kPageHeight = 2970.0;
inline constexpr double kSideMargin = 180.0;
inline constexpr double kTop = 230.0;
inline constexpr double kBottom = 2790.0;
inline constexpr double kContentWidth = kPageWidth - 2.0 * kSideMargin;
inline constexpr double kContentHeight = kBottom - kTop;
inline constexpr int kUnitsPerInch = 254;
/// One pixel of a screen of 96 dpi.
inline constexpr double kUnitsPerScreenPixel = 254.0 / 96.0;

enum class Face { Body, Small, Bold, Mono, Heading, Title, Statement };

/// DejaVu Sans, which every installation has, so that a report looks alike everywhere.
QFont font(Face face);

/// The light theme: reports are printed.
const Theme& colours();

}  // namespace fodscope::report
