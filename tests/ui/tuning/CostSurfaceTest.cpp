// SPDX-License-Identifier: MIT
#include "ui/tuning/CostSurface.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <limits>

#include "tests/ui/Screenshot.h"
#include "ui/theme/Colours.h"

namespace fodscope::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

CostGrid sampleGrid() {
    return {{0.1, 0.2, 0.3}, {1.0, 2.0}, {0.5, 0.4, 0.9, 0.4, kNaN, 7.5}};
}

TEST(CostGrid, CheapestCellIsTheOneWithTheLowerThresholdOfTwo) {
    EXPECT_EQ(cheapestCell(sampleGrid()), (CostCell{1, 0}));
    EXPECT_FALSE(cheapestCell({{0.1}, {1.0}, {kNaN}}).has_value());
}

TEST(CostGrid, SettingsThatFindNothingDoNotTakeAllColours) {
    CostGrid grid{{}, {}, std::vector<double>(95, 0.3)};
    grid.cost_m[0] = 0.1;
    grid.cost_m.insert(grid.cost_m.end(), 5, 7.5);
    const CostRange range = costRange(grid);
    EXPECT_DOUBLE_EQ(range.least_m, 0.1);
    EXPECT_DOUBLE_EQ(range.most_m, 0.3);
}

TEST(CostGrid, PictureHasThresholdsUpwardsAndHolesWhereNothingIsKnown) {
    const QImage image = costImage(sampleGrid(), {0.4, 0.9});
    ASSERT_EQ(image.size(), QSize(3, 2));
    EXPECT_EQ(image.pixelColor(1, 1).rgb(), viridis(0.0).rgb());
    EXPECT_EQ(image.pixelColor(2, 1).rgb(), viridis(1.0).rgb());
    EXPECT_EQ(image.pixelColor(2, 0).rgb(), viridis(1.0).rgb());
    EXPECT_EQ(image.pixelColor(1, 0).alpha(), 0);
}

TEST(CostSurface, ClickChoosesTheCellUnderThePointer) {
    CostSurface surface;
    surface.resize(620, 400);
    surface.setGrid(sampleGrid(), {0.4, 0.9});
    surface.show();
    std::optional<CostCell> chosen;
    QObject::connect(&surface, &CostSurface::cellChosen, [&chosen](const CostCell& cell) { chosen = cell; });
    QTest::mouseClick(&surface, Qt::LeftButton, {}, surface.centreOf({2, 1}).toPoint());
    EXPECT_EQ(chosen, (CostCell{2, 1}));
    QTest::mouseClick(&surface, Qt::LeftButton, {}, QPoint(2, 2));
    EXPECT_EQ(surface.chosen(), (CostCell{2, 1}));
}

TEST(CostSurface, ArrowKeysWalkAndStopAtTheEdges) {
    CostSurface surface;
    surface.setGrid(sampleGrid(), {0.4, 0.9});
    surface.setBest(CostCell{1, 0});
    QTest::keyClick(&surface, Qt::Key_Right);
    QTest::keyClick(&surface, Qt::Key_Right);
    QTest::keyClick(&surface, Qt::Key_Up);
    QTest::keyClick(&surface, Qt::Key_Up);
    EXPECT_EQ(surface.chosen(), (CostCell{2, 1}));
    QTest::keyClick(&surface, Qt::Key_Home);
    EXPECT_EQ(surface.chosen(), (CostCell{1, 0}));
}

}  // namespace
}  // namespace fodscope::test
