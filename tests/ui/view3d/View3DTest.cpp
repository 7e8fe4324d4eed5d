// SPDX-License-Identifier: MIT
#include "ui/view3d/View3D.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <cmath>

#include "ui/theme/Colours.h"

namespace fodscope {
namespace {

/// A square floor, 2 m wide, with points 2 cm apart.
std::vector<Eigen::Vector3d> floorPoints(double z_m = 0.0) {
    std::vector<Eigen::Vector3d> points;
    for (int x = -50; x <= 50; ++x) {
        for (int y = -50; y <= 50; ++y)
            points.emplace_back(0.02 * x, 0.02 * y, z_m);
    }
    return points;
}

bool isNear(QRgb a, QRgb b, int tolerance) {
    return std::abs(qRed(a) - qRed(b)) <= tolerance && std::abs(qGreen(a) - qGreen(b)) <= tolerance &&
           std::abs(qBlue(a) - qBlue(b)) <= tolerance;
}

class View3DTest : public testing::Test {
  protected:
    void SetUp() override {
        view.resize(400, 320);
        view.setToolBarVisible(false);
        view.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
        view.setLayerVisible(ViewLayer::Grid, false);
    }

    /// Pixels in the middle of the picture that are not background; the edges hold axes, scale and legend.
    int drawnPixels() {
        const QImage image = view.grabImage();
        const QRgb background = currentTheme().surface0.rgb();
        int count = 0;
        for (int y = image.height() / 4; y < image.height() * 3 / 4; ++y) {
            for (int x = image.width() / 4; x < image.width() * 3 / 4; ++x) {
                if (!isNear(image.pixel(x, y), background, 6)) ++count;
            }
        }
        return count;
    }

    /// The colour that most drawn pixels in the middle have.
    QRgb centreColour() {
        const QImage image = view.grabImage();
        const QRgb background = currentTheme().surface0.rgb();
        QMap<QRgb, int> counts;
        for (int y = image.height() / 2 - 20; y < image.height() / 2 + 20; ++y) {
            for (int x = image.width() / 2 - 20; x < image.width() / 2 + 20; ++x) {
                if (!isNear(image.pixel(x, y), background, 6)) ++counts[image.pixel(x, y)];
            }
        }
        QRgb best = 0;
        for (auto it = counts.begin(); it != counts.end(); ++it) {
            if (it.value() > counts.value(best, 0)) best = it.key();
        }
        return best;
    }

    QWidget* canvas() { return view.childAt(view.rect().center()); }

    View3D view;
};

TEST_F(View3DTest, GrabbedPicturesHoldTheCloud) {
    EXPECT_FALSE(view.hasLayer(ViewLayer::Reference));
    view.setReference(floorPoints());
    EXPECT_TRUE(view.hasLayer(ViewLayer::Reference));
    EXPECT_GT(drawnPixels(), 2000);
}

TEST_F(View3DTest, LayersCanBeHiddenAndShown) {
    view.setReference(floorPoints());
    QSignalSpy changes(&view, &View3D::layerVisibilityChanged);
    const int shown = drawnPixels();
    view.setLayerVisible(ViewLayer::Reference, false);
    EXPECT_LT(drawnPixels(), shown / 20);
    view.setLayerVisible(ViewLayer::Reference, true);
    EXPECT_NEAR(drawnPixels(), shown, shown / 50);
    EXPECT_EQ(changes.count(), 2);
}

TEST_F(View3DTest, NotKnownLooksDifferentFromZero) {
    const auto points = floorPoints();
    ScalarStyle style;
    style.title = QStringLiteral("Discrepancy");
    style.maximum = 5.0;
    view.setDiscrepancy(points, std::vector<double>(points.size(), 0.0), style);
    const QRgb zero = centreColour();
    view.setDiscrepancy(points, std::vector<double>(points.size(), std::nan("")), style);
    const QRgb unknown = centreColour();
    EXPECT_NE(qAlpha(zero), 0) << "zero is drawn";
    EXPECT_NE(qAlpha(unknown), 0) << "not known is drawn";
    EXPECT_FALSE(isNear(zero, unknown, 12)) << std::hex << zero << " " << unknown;
}

TEST_F(View3DTest, TheThresholdChangesThePictureAtOnce) {
    const auto points = floorPoints();
    ScalarStyle style;
    style.maximum = 5.0;
    style.threshold = 3.0;
    view.setDiscrepancy(points, std::vector<double>(points.size(), 4.0), style);
    const QRgb above = centreColour();
    view.setDiscrepancyThreshold(4.5);
    EXPECT_FALSE(isNear(above, centreColour(), 12));
}

TEST_F(View3DTest, PickFindsThePointUnderThePointer) {
    const auto points = floorPoints();
    view.setReference(points);
    view.setStandardView(StandardView::Isometric);
    view.grabImage();
    for (const std::size_t wanted : {std::size_t{0}, points.size() / 2, points.size() - 7}) {
        const auto spot = view.positionOnScreen(points[wanted]);
        ASSERT_TRUE(spot.has_value());
        const auto found = view.pickAt(spot->toPoint());
        ASSERT_TRUE(found.has_value());
        EXPECT_EQ(found->layer, ViewLayer::Reference);
        EXPECT_LT((found->position - points[wanted]).norm(), 0.03);
    }
    EXPECT_FALSE(view.pickAt(QPoint(2, 2)).has_value());
}

TEST_F(View3DTest, PeelHidesWhatIsAbove) {
    view.setReference(floorPoints(2.0));
    const int all = drawnPixels();
    view.setPeelHeight(1.0);
    EXPECT_LT(drawnPixels(), all / 20);
    EXPECT_FALSE(view.pickAt(view.rect().center()).has_value());
    view.setPeelHeight(std::nullopt);
    EXPECT_NEAR(drawnPixels(), all, all / 50);
}

TEST_F(View3DTest, ADeckIsPeeledUntilTheOperatorSaysOtherwise) {
    auto points = floorPoints(0.0);
    const auto deck = floorPoints(1.5);
    points.insert(points.end(), deck.begin(), deck.end());
    view.setReference(points);
    ASSERT_TRUE(view.peelHeight().has_value());
    EXPECT_LT(*view.peelHeight(), 1.5);
    view.setPeelHeight(std::nullopt);
    view.setReference(points);
    EXPECT_FALSE(view.peelHeight().has_value());
}

TEST_F(View3DTest, AWaypointIsSelectedByItsMark) {
    view.setReference(floorPoints());
    ViewWaypoint waypoint;
    waypoint.id = QStringLiteral("W-02");
    waypoint.pose = {-0.4, 0.3, 0.0};
    view.setWaypoints({waypoint});
    view.grabImage();
    QSignalSpy selected(&view, &View3D::waypointSelected);
    QTest::mouseClick(canvas(), Qt::LeftButton, {}, view.positionOnScreen(Eigen::Vector3d(-0.4, 0.3, 0.0))->toPoint());
    ASSERT_EQ(selected.count(), 1);
    EXPECT_EQ(selected.at(0).at(0).toString(), waypoint.id);
}

TEST_F(View3DTest, ClickSelectsTheCandidateAndDoubleClickActivatesIt) {
    view.setReference(floorPoints());
    ViewCandidate candidate;
    candidate.id = QStringLiteral("C-003");
    for (int i = -5; i <= 5; ++i)
        candidate.points.emplace_back(0.3 + 0.02 * i, 0.2, 0.05);
    candidate.centroid = {0.3, 0.2, 0.05};
    view.setCandidates({candidate});
    view.grabImage();
    QSignalSpy selected(&view, &View3D::candidateSelected);
    QSignalSpy activated(&view, &View3D::candidateActivated);
    const QPoint at = view.positionOnScreen(candidate.centroid)->toPoint();
    QTest::mouseClick(canvas(), Qt::LeftButton, {}, at);
    ASSERT_EQ(selected.count(), 1);
    EXPECT_EQ(selected.at(0).at(0).toString(), candidate.id);
    QTest::mouseDClick(canvas(), Qt::LeftButton, {}, at);
    ASSERT_EQ(activated.count(), 1);
    EXPECT_EQ(activated.at(0).at(0).toString(), candidate.id);
    QTest::mouseClick(canvas(), Qt::LeftButton, {}, QPoint(3, 3));
    EXPECT_TRUE(selected.last().at(0).toString().isEmpty()) << "the background selects nothing";
}

TEST_F(View3DTest, TwoClicksMeasureADistance) {
    view.setReference(floorPoints());
    view.setStandardView(StandardView::Top);
    view.grabImage();
    view.setMeasuring(true);
    QSignalSpy measured(&view, &View3D::distanceMeasured);
    for (const double x : {-0.5, 0.5}) {
        const QPoint at = view.positionOnScreen(Eigen::Vector3d(x, 0.0, 0.0))->toPoint();
        QTest::mouseClick(canvas(), Qt::LeftButton, {}, at);
    }
    ASSERT_EQ(measured.count(), 1);
    EXPECT_NEAR(measured.at(0).at(0).toDouble(), 1.0, 0.03);
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_FALSE(view.isMeasuring());
}

TEST_F(View3DTest, ClearLeavesNothing) {
    view.setReference(floorPoints());
    view.setRobot(ViewRobot{});
    view.clear();
    for (const ViewLayer layer : {ViewLayer::Reference, ViewLayer::Discrepancy, ViewLayer::Robot, ViewLayer::Grid}) {
        EXPECT_FALSE(view.hasLayer(layer)) << toString(layer).toStdString();
    }
}

TEST_F(View3DTest, AReferenceWithoutValuesIsPlainAgain) {
    const auto points = floorPoints();
    view.setReference(points);
    const int plain = drawnPixels();
    ScalarStyle style;
    view.setReferenceValues(std::vector<double>(points.size(), std::nan("")), style);
    view.setReferenceValues({}, {});
    EXPECT_NEAR(drawnPixels(), plain, plain / 50);
}

TEST_F(View3DTest, ValuesThatDoNotMatchThePointsAreNotKnown) {
    const auto points = floorPoints();
    ScalarStyle style;
    view.setDiscrepancy(points, std::vector<double>(3, 1.0), style);
    EXPECT_GT(drawnPixels(), 500);
}

}  // namespace
}  // namespace fodscope
