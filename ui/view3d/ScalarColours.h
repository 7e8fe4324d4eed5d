// SPDX-License-Identifier: MIT
#pragma once

#include <QRgb>
#include <cstdint>
#include <span>
#include <vector>

#include "ui/theme/Theme.h"
#include "ui/view3d/View3D.h"

namespace fodscope {

/// How a point with a value is drawn.
enum class ValueGroup : std::uint8_t { Unknown, Below, Above };

/// NaN is Unknown. Without a threshold everything known is Above.
ValueGroup valueGroup(double value, const ScalarStyle& style);

/// @param t in 0..1
QColor scaleColour(double t, ColourScale scale);

/// The colour of a value: the scale over the absolute range; below the threshold dimmed towards the background; NaN in
/// the theme's grey, which viridis does not contain.
QRgb scalarColour(double value, const ScalarStyle& style, const Theme& theme);
std::vector<QRgb> scalarColours(std::span<const double> values, const ScalarStyle& style, const Theme& theme);

/// Indices of the points of each group, ascending.
struct IndexGroups {
    std::vector<std::int64_t> below;
    std::vector<std::int64_t> above;
    std::vector<std::int64_t> unknown;
};
IndexGroups indexGroups(std::span<const double> values, const ScalarStyle& style);

}  // namespace fodscope
