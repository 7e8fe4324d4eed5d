// SPDX-License-Identifier: MIT
#include "ui/tuning/RecallPlot.h"

#include <gtest/gtest.h>

#include <QTest>
#include <cmath>

#include "core/evaluation/PhotoSearch.h"

namespace fodscope::test {
namespace {

RecallPoints samplePoints() {
    RecallPoints points;
    points.curve = {{0.3, 1.0, 3}, {0.6, 0.75, 8}, {0.9, 0.5, 20}};
    points.all = points.curve;
    points.wantedRecall = 0.8;
    return points;
}

TEST(RecallPoints, EverySettingWithPhotosIsAPlaceAndEachPlaceComesOnce) {
    PhotoSearchResult result;
    result.fodCount = 4;
    result.outcomes = {PhotoOutcome{4, 2, 2, 4, 0}, std::nullopt, PhotoOutcome{2, 1, 2, 3, 0}, PhotoOutcome{}};
    result.curve = {{{0, 0, 0}, PhotoOutcome{}}, {{0, 2, 0}, PhotoOutcome{2, 1, 2, 3, 0}}};
    const RecallPoints points = recallPointsOf(result);
    ASSERT_EQ(points.all.size(), 1u);
    EXPECT_DOUBLE_EQ(points.all[0].recall, 0.5);
    EXPECT_DOUBLE_EQ(points.all[0].precision, 0.5);
    ASSERT_EQ(points.curve.size(), 2u) << "its points stay those of the search";
    EXPECT_TRUE(std::isnan(points.curve[0].precision)) << "no photos have no precision";
}

TEST(RecallPlot, ClickChoosesThePointOfNearestRecall) {
    RecallPlot plot;
    plot.resize(620, 400);
    plot.setPoints(samplePoints());
    plot.show();
    std::optional<std::size_t> chosen;
    QObject::connect(&plot, &RecallPlot::pointChosen, [&chosen](std::size_t point) { chosen = point; });
    const QPointF between = plot.placeOf({0.55, 0.2, 0});
    QTest::mouseClick(&plot, Qt::LeftButton, {}, between.toPoint());
    EXPECT_EQ(chosen, 1u);
    EXPECT_EQ(plot.chosen(), 1u);
}

TEST(RecallPlot, ArrowKeysWalkAlongTheCurveAndHomeIsTheBest) {
    RecallPlot plot;
    plot.setPoints(samplePoints());
    plot.setBest(1);
    plot.setChosen(1);
    QTest::keyClick(&plot, Qt::Key_Right);
    QTest::keyClick(&plot, Qt::Key_Right);
    EXPECT_EQ(plot.chosen(), 2u);
    for (int i = 0; i < 4; ++i)
        QTest::keyClick(&plot, Qt::Key_Left);
    EXPECT_EQ(plot.chosen(), 0u);
    QTest::keyClick(&plot, Qt::Key_Home);
    EXPECT_EQ(plot.chosen(), 1u);
}

TEST(RecallPlot, BeforeASearchNothingCanBeChosen) {
    RecallPlot plot;
    plot.resize(620, 400);
    QTest::mouseClick(&plot, Qt::LeftButton);
    QTest::keyClick(&plot, Qt::Key_Right);
    EXPECT_FALSE(plot.chosen().has_value());
}

}  // namespace
}  // namespace fodscope::test
