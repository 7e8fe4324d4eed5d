// SPDX-License-Identifier: MIT
#include "ui/widgets/ThresholdHistogram.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <cmath>

namespace fodscope {
namespace {

class ThresholdHistogramTest : public testing::Test {
  protected:
    ThresholdHistogramTest() {
        std::vector<double> values;
        for (int i = 0; i <= 1000; ++i)
            values.push_back(i / 100.0);
        widget.setValues(values);
        widget.setSteps(0.05, 0.5);
        widget.setThreshold(2.75);
        widget.resize(320, 140);
        widget.show();
    }

    ThresholdHistogram widget;
};

TEST_F(ThresholdHistogramTest, KeysMoveByFineAndCoarseSteps) {
    QSignalSpy dragged(&widget, &ThresholdHistogram::thresholdDragged);
    QSignalSpy released(&widget, &ThresholdHistogram::thresholdReleased);
    QTest::keyClick(&widget, Qt::Key_Right);
    EXPECT_NEAR(widget.threshold(), 2.80, 1e-9);
    QTest::keyClick(&widget, Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_NEAR(widget.threshold(), 2.5, 0.26) << "a coarse step ends on the grid of coarse steps";
    EXPECT_EQ(dragged.count(), 2);
    EXPECT_EQ(released.count(), 2);
}

TEST_F(ThresholdHistogramTest, KeysStopAtTheEnds) {
    QTest::keyClick(&widget, Qt::Key_Home);
    EXPECT_EQ(widget.threshold(), 0.0);
    QSignalSpy released(&widget, &ThresholdHistogram::thresholdReleased);
    QTest::keyClick(&widget, Qt::Key_Left);
    EXPECT_EQ(widget.threshold(), 0.0);
    EXPECT_EQ(released.count(), 0) << "nothing changed, nothing is told";
}

TEST_F(ThresholdHistogramTest, DraggingTellsAllTheWayAndOnceAtTheEnd) {
    QSignalSpy dragged(&widget, &ThresholdHistogram::thresholdDragged);
    QSignalSpy released(&widget, &ThresholdHistogram::thresholdReleased);
    QTest::mousePress(&widget, Qt::LeftButton, {}, QPoint(100, 70));
    for (int x = 110; x <= 200; x += 10) {
        QMouseEvent move(QEvent::MouseMove, QPointF(x, 70), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&widget, &move);
    }
    EXPECT_EQ(released.count(), 0);
    QTest::mouseRelease(&widget, Qt::LeftButton, {}, QPoint(200, 70));
    EXPECT_GT(dragged.count(), 5);
    ASSERT_EQ(released.count(), 1);
    // 10 px at each side, values 0 to 10.
    EXPECT_NEAR(released.at(0).at(0).toDouble(), 10.0 * (200 - 10) / 300.0, 0.1);
}

TEST_F(ThresholdHistogramTest, TellsHowManyAreAbove) {
    widget.setThreshold(7.5);
    EXPECT_EQ(widget.countAbove(), 250U);
    EXPECT_NEAR(widget.shareAbove(), 250.0 / 1001.0, 1e-12);
}

TEST_F(ThresholdHistogramTest, SettingTheThresholdIsSilent) {
    QSignalSpy dragged(&widget, &ThresholdHistogram::thresholdDragged);
    widget.setThreshold(1.0);
    EXPECT_EQ(dragged.count(), 0);
}

TEST_F(ThresholdHistogramTest, WithoutValuesItIsEmptyNotWrong) {
    widget.clear();
    EXPECT_EQ(widget.countAbove(), 0U);
    EXPECT_EQ(widget.shareAbove(), 0.0);
    QTest::mouseClick(&widget, Qt::LeftButton, {}, QPoint(50, 50));
    EXPECT_EQ(widget.threshold(), 2.75);
    const std::vector<double> unknown(3, std::nan(""));
    widget.setValues(unknown);
    EXPECT_EQ(widget.countUnknown(), 3U);
    EXPECT_FALSE(widget.grab().isNull());
}

}  // namespace
}  // namespace fodscope
