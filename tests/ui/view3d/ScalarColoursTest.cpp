// SPDX-License-Identifier: MIT
#include "ui/view3d/ScalarColours.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "ui/theme/Colours.h"

namespace fodscope {
namespace {

ScalarStyle styleTo(double maximum, std::optional<double> threshold) {
    ScalarStyle style;
    style.maximum = maximum;
    style.threshold = threshold;
    return style;
}

TEST(ScalarColours, UnknownIsNeverDrawnAsAValue) {
    for (const ThemeKind kind : {ThemeKind::Dark, ThemeKind::Light}) {
        const Theme theme = makeTheme(kind);
        const QRgb unknown = scalarColour(std::nan(""), styleTo(5.0, 2.0), theme);
        for (double value = 0.0; value <= 5.0; value += 0.01) {
            EXPECT_NE(unknown, scalarColour(value, styleTo(5.0, 2.0), theme)) << value;
            EXPECT_NE(unknown, scalarColour(value, styleTo(5.0, std::nullopt), theme)) << value;
        }
    }
}

TEST(ScalarColours, TheThresholdItselfIsNotAbove) {
    const ScalarStyle style = styleTo(5.0, 2.75);
    EXPECT_EQ(valueGroup(2.75, style), ValueGroup::Below);
    EXPECT_EQ(valueGroup(std::nextafter(2.75, 3.0), style), ValueGroup::Above);
    EXPECT_EQ(valueGroup(std::nan(""), style), ValueGroup::Unknown);
}

TEST(ScalarColours, TheRangeIsAbsolute) {
    const Theme theme = makeTheme(ThemeKind::Dark);
    const ScalarStyle style = styleTo(5.0, std::nullopt);
    EXPECT_EQ(scalarColour(0.0, style, theme), viridis(0.0).rgb());
    EXPECT_EQ(scalarColour(5.0, style, theme), viridis(1.0).rgb());
    EXPECT_EQ(scalarColour(50.0, style, theme), viridis(1.0).rgb()) << "beyond the range is the range's end";
}

TEST(ScalarColours, ManyAtOnceAreWhatEachIsAlone) {
    const Theme theme = makeTheme(ThemeKind::Dark);
    const ScalarStyle style = styleTo(4.0, 1.0);
    const std::vector<double> values = {0.0, 0.5, 1.0, 1.5, 3.999, 7.0, std::nan("")};
    const auto colours = scalarColours(values, style, theme);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const QRgb alone = scalarColour(values[i], style, theme);
        EXPECT_NEAR(qRed(colours[i]), qRed(alone), 2) << i;
        EXPECT_NEAR(qGreen(colours[i]), qGreen(alone), 2) << i;
        EXPECT_NEAR(qBlue(colours[i]), qBlue(alone), 2) << i;
    }
}

TEST(ScalarColours, EveryPointIsInExactlyOneGroup) {
    const std::vector<double> values = {0.0, 0.5, 1.0, 1.5, 3.999, 7.0, std::nan("")};
    const IndexGroups groups = indexGroups(values, styleTo(4.0, 1.0));
    EXPECT_EQ(groups.below, (std::vector<std::int64_t>{0, 1, 2}));
    EXPECT_EQ(groups.above, (std::vector<std::int64_t>{3, 4, 5}));
    EXPECT_EQ(groups.unknown, (std::vector<std::int64_t>{6}));
}

TEST(ScalarColours, AnEmptyRangeDividesByNothing) {
    ScalarStyle style = styleTo(0.0, std::nullopt);
    EXPECT_EQ(scalarColour(1.0, style, makeTheme(ThemeKind::Dark)), viridis(0.0).rgb());
}

}  // namespace
}  // namespace fodscope
