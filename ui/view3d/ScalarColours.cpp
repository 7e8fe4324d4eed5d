// SPDX-License-Identifier: MIT
#include "ui/view3d/ScalarColours.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/theme/Colours.h"

namespace fodscope {
namespace {

constexpr double kDimming = 0.55;
constexpr std::size_t kSteps = 512;

QRgb known(double t, ColourScale scale, bool above, const Theme& theme) {
    const QColor full = scaleColour(t, scale);
    return (above ? full : mixed(full, theme.surface2, kDimming)).rgb();
}

QRgb unknown(const Theme& theme) {
    return mixed(theme.surface0, theme.muted, 0.55).rgb();
}

double positionIn(const ScalarStyle& style, double value) {
    const double span = style.maximum - style.minimum;
    return span > 0.0 ? std::clamp((value - style.minimum) / span, 0.0, 1.0) : 0.0;
}

}  // namespace

QColor scaleColour(double t, ColourScale scale) {
    return scale == ColourScale::Diverging ? diverging(t) : viridis(t);
}

ValueGroup valueGroup(double value, const ScalarStyle& style) {
    if (std::isnan(value)) return ValueGroup::Unknown;
    return !style.threshold || value > *style.threshold ? ValueGroup::Above : ValueGroup::Below;
}

QRgb scalarColour(double value, const ScalarStyle& style, const Theme& theme) {
    const ValueGroup group = valueGroup(value, style);
    if (group == ValueGroup::Unknown) return unknown(theme);
    return known(positionIn(style, value), style.scale, group == ValueGroup::Above, theme);
}

std::vector<QRgb> scalarColours(std::span<const double> values, const ScalarStyle& style, const Theme& theme) {
    // A million QColor mixes would be felt while dragging a slider; a table of steps is not.
    std::array<std::array<QRgb, kSteps>, 2> table;
    for (std::size_t step = 0; step < kSteps; ++step) {
        const double t = static_cast<double>(step) / (kSteps - 1);
        table[0][step] = known(t, style.scale, false, theme);
        table[1][step] = known(t, style.scale, true, theme);
    }
    const QRgb none = unknown(theme);
    std::vector<QRgb> colours(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const ValueGroup group = valueGroup(values[i], style);
        const auto step = group == ValueGroup::Unknown
                              ? std::size_t{0}
                              : static_cast<std::size_t>(positionIn(style, values[i]) * (kSteps - 1) + 0.5);
        colours[i] = group == ValueGroup::Unknown ? none : table[group == ValueGroup::Above ? 1 : 0][step];
    }
    return colours;
}

IndexGroups indexGroups(std::span<const double> values, const ScalarStyle& style) {
    IndexGroups groups;
    groups.below.reserve(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const ValueGroup group = valueGroup(values[i], style);
        auto& list = group == ValueGroup::Below   ? groups.below
                     : group == ValueGroup::Above ? groups.above
                                                  : groups.unknown;
        list.push_back(static_cast<std::int64_t>(i));
    }
    return groups;
}

}  // namespace fodscope
