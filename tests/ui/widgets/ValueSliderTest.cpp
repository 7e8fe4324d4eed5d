// SPDX-License-Identifier: MIT
#include "ui/widgets/ValueSlider.h"

#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>

namespace fodscope {
namespace {

ValueRange cutoffInCentimetres() {
    ValueRange range;
    range.minimum = 0.05;
    range.maximum = 1.0;
    range.step = 0.005;
    range.coarseStep = 0.05;
    range.unit = QStringLiteral("cm");
    range.displayFactor = 100.0;
    range.decimals = 1;
    return range;
}

class ValueSliderTest : public testing::Test {
  protected:
    ValueSliderTest() : widget(QStringLiteral("Cluster cutoff"), cutoffInCentimetres()) {
        widget.setValue(0.345);
        widget.show();
    }

    QSlider* slider() { return widget.findChild<QSlider*>(); }
    QDoubleSpinBox* box() { return widget.findChild<QDoubleSpinBox*>(); }

    ValueSlider widget;
};

TEST_F(ValueSliderTest, ShowsTheValueInItsUnit) {
    EXPECT_NEAR(box()->value(), 34.5, 1e-9);
    EXPECT_TRUE(box()->text().endsWith(QStringLiteral("cm")));
}

TEST_F(ValueSliderTest, KeysOnTheSliderStepAndCommit) {
    QSignalSpy committed(&widget, &ValueSlider::valueCommitted);
    QTest::keyClick(slider(), Qt::Key_Right);
    EXPECT_NEAR(widget.value(), 0.35, 1e-9);
    QTest::keyClick(slider(), Qt::Key_PageUp);
    EXPECT_NEAR(widget.value(), 0.40, 1e-9);
    EXPECT_EQ(committed.count(), 2);
    EXPECT_NEAR(box()->value(), 40.0, 1e-9);
}

TEST_F(ValueSliderTest, TypedNumbersMayLieBetweenTheSteps) {
    QSignalSpy committed(&widget, &ValueSlider::valueCommitted);
    box()->setFocus();
    box()->selectAll();
    QTest::keyClicks(box(), box()->locale().toString(27.9, 'f', 1));
    QTest::keyClick(box(), Qt::Key_Return);
    EXPECT_NEAR(widget.value(), 0.279, 1e-9);
    ASSERT_EQ(committed.count(), 1);
    EXPECT_NEAR(committed.at(0).at(0).toDouble(), 0.279, 1e-9);
}

TEST_F(ValueSliderTest, DraggingChangesAndCommitsOnceAtTheEnd) {
    QSignalSpy changing(&widget, &ValueSlider::valueChanging);
    QSignalSpy committed(&widget, &ValueSlider::valueCommitted);
    slider()->setSliderDown(true);
    for (int position = 60; position <= 80; position += 5)
        slider()->setSliderPosition(position);
    EXPECT_GT(changing.count(), 3);
    EXPECT_EQ(committed.count(), 0);
    slider()->setSliderDown(false);
    EXPECT_EQ(committed.count(), 1);
    EXPECT_NEAR(widget.value(), 0.05 + 80 * 0.005, 1e-9);
}

TEST_F(ValueSliderTest, ClampsAndSetsSilently) {
    QSignalSpy changing(&widget, &ValueSlider::valueChanging);
    QSignalSpy committed(&widget, &ValueSlider::valueCommitted);
    widget.setValue(5.0);
    EXPECT_EQ(widget.value(), 1.0);
    widget.setValue(0.279);
    EXPECT_EQ(widget.value(), 0.279) << "setting does not round to the slider's steps";
    EXPECT_EQ(changing.count() + committed.count(), 0);
}

TEST_F(ValueSliderTest, OffersTheWayBackToTheDefault) {
    auto* reset = widget.findChild<QToolButton*>();
    widget.setDefaultValue(0.345);
    EXPECT_TRUE(reset->isHidden());
    QTest::keyClick(slider(), Qt::Key_Right);
    ASSERT_FALSE(reset->isHidden());
    QSignalSpy committed(&widget, &ValueSlider::valueCommitted);
    reset->click();
    EXPECT_NEAR(widget.value(), 0.345, 1e-12);
    EXPECT_EQ(committed.count(), 1);
    EXPECT_TRUE(reset->isHidden());
}

}  // namespace
}  // namespace fodscope
