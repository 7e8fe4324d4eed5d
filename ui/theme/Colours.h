// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>

namespace fodscope {

/// Okabe-Ito, a cycle of eight that colour-blind people can tell apart. Black is replaced by a light or dark grey so
/// that it shows on the theme's surface. Index 8 is index 0 again.
QColor candidateColour(int index);
inline constexpr int kCandidateColours = 8;

/// The number in "C-012" makes the colour, so that a candidate keeps it when others come or go.
QColor candidateColour(const QString& candidateId);

/// matplotlib's viridis at t in 0..1, clamped; an invalid QColor for NaN, which must never look like a value.
QColor viridis(double t);

/// Blue over light grey to red at t in 0..1, clamped, for deviations to either side: ColorBrewer's RdBu, which
/// colour-blind people can read; an invalid QColor for NaN.
QColor diverging(double t);

/// @return `a` with `share` of `b` mixed in (0: a, 1: b)
QColor mixed(const QColor& a, const QColor& b, double share);

}  // namespace fodscope
