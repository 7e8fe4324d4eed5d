// SPDX-License-Identifier: MIT
#include "ui/plan/PlanView.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>

#include "tests/fakes/TankInspection.h"
#include "tests/ui/Screenshot.h"
#include "ui/plan/PlanPainter.h"
#include "ui/plan/PlanWords.h"

namespace fodscope {
namespace {

class PlanOnScreen : public testing::Test {
  protected:
    PlanOnScreen() {
        view.resize(900, 600);
        view.show();
        view.setScene(planScene(state));
        view.grab();
    }

    /// The middle of a thing as the fitted view shows it.
    QPoint placeOf(const Eigen::Vector2d& place_map) {
        QPixmap canvas(view.size());
        QPainter painter(&canvas);
        PlanLook look;
        look.theme = currentTheme();
        const double legend = paintPlanLegend(painter, view.rect(), view.scene(), look, false);
        const QRectF area(0, 0, view.width(), view.height() - legend);
        return fittedPlan(planExtent(view.scene()), area).toScreen(place_map).toPoint();
    }

    InspectionState state = tankInspection();
    PlanView view;
};

TEST_F(PlanOnScreen, AClickSelectsACandidate) {
    QSignalSpy selected(&view, &PlanView::candidateSelected);
    QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, placeOf(view.scene().candidates[1].centroid_map));
    ASSERT_EQ(selected.count(), 1);
    EXPECT_EQ(selected.at(0).at(0).toString(), "C-002");
}

TEST_F(PlanOnScreen, AClickSelectsAWaypoint) {
    QSignalSpy selected(&view, &PlanView::waypointSelected);
    const PlanWaypoint& waypoint = view.scene().waypoints.front();
    QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, placeOf({waypoint.pose_map.x_m, waypoint.pose_map.y_m}));
    ASSERT_EQ(selected.count(), 1);
    EXPECT_EQ(selected.at(0).at(0).toString(), QString::fromStdString(waypoint.id));
}

TEST_F(PlanOnScreen, ADragMovesThePlanAndSelectsNothing) {
    QSignalSpy candidate(&view, &PlanView::candidateSelected);
    const QPoint place = placeOf(view.scene().candidates[1].centroid_map);
    QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, place);
    QMouseEvent move(QEvent::MouseMove, place + QPoint(60, 0), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&view, &move);
    QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, place + QPoint(60, 0));
    EXPECT_EQ(candidate.count(), 0);
    QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, place + QPoint(60, 0));
    EXPECT_EQ(candidate.count(), 1) << "the candidate moved with the drag";
    view.fit();
    QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, place);
    EXPECT_EQ(candidate.count(), 2) << "fit brings it back";
}

TEST_F(PlanOnScreen, AWaypointIsDraggedOnlyWhereThePlanMayBeChanged) {
    QSignalSpy moved(&view, &PlanView::waypointMoved);
    const PlanWaypoint waypoint = view.scene().waypoints.front();
    const QPoint place = placeOf({waypoint.pose_map.x_m, waypoint.pose_map.y_m});
    const auto drag = [&] {
        QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, place);
        QMouseEvent move(QEvent::MouseMove, place + QPoint(30, 12), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&view, &move);
        view.grab();
        QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, place + QPoint(30, 12));
    };
    view.setEditable(true);
    drag();
    ASSERT_EQ(moved.count(), 1);
    EXPECT_EQ(moved.at(0).at(0).toString(), QString::fromStdString(waypoint.id));
    EXPECT_EQ(placeOf(view.scene().candidates[0].centroid_map),
              placeOf(state.detection->candidates->candidates[0].centroid_map.head<2>()))
        << "the plan stays where it is";
    view.setEditable(false);
    drag();
    EXPECT_EQ(moved.count(), 1);
}

TEST_F(PlanOnScreen, ADoubleClickOnTheFloorAddsAndDeleteRemovesAWaypoint) {
    QSignalSpy added(&view, &PlanView::waypointAdded);
    QSignalSpy removed(&view, &PlanView::waypointRemoved);
    const QPoint floor = placeOf({0.25, 2.3});
    QTest::mouseDClick(&view, Qt::LeftButton, Qt::NoModifier, floor);
    EXPECT_EQ(added.count(), 0) << "the plan may not be changed";
    view.setEditable(true);
    QTest::mouseDClick(&view, Qt::LeftButton, Qt::NoModifier, floor);
    EXPECT_EQ(added.count(), 1);
    QTest::keyClick(&view, Qt::Key_Delete);
    EXPECT_EQ(removed.count(), 0) << "none is selected";
    view.setSelectedWaypoint(QStringLiteral("W-02"));
    QTest::keyClick(&view, Qt::Key_Delete);
    ASSERT_EQ(removed.count(), 1);
    EXPECT_EQ(removed.at(0).at(0).toString(), "W-02");
}

TEST_F(PlanOnScreen, SelectingFromOutsideSendsNothingBack) {
    QSignalSpy candidate(&view, &PlanView::candidateSelected);
    QSignalSpy waypoint(&view, &PlanView::waypointSelected);
    view.setSelectedCandidate(QStringLiteral("C-002"));
    view.setSelectedWaypoint(QStringLiteral("W-01"));
    EXPECT_EQ(candidate.count() + waypoint.count(), 0);
}

TEST_F(PlanOnScreen, TheToolTipSaysWhyThereIsNoWaypoint) {
    const QString text = planToolTip(view.scene(), {PlanItem::Candidate, "C-008"}, {});
    EXPECT_TRUE(text.contains(QStringLiteral("No waypoint"))) << text.toStdString();
    EXPECT_TRUE(planToolTip(view.scene(), {}, {100, 100}).isEmpty());
    EXPECT_TRUE(planToolTip(view.scene(), {}, {0.1, 2.4}).contains(QStringLiteral("not observed")));
}

TEST_F(PlanOnScreen, LooksAsDesigned) {
    std::vector<Visit> visits = state.visits;
    ASSERT_GE(visits.size(), 6U);
    visits[2].state = VisitState::Failed;
    visits[2].reason = VisitReason::Aborted;
    visits[2].detail = "no path";
    visits[3].state = VisitState::Driving;
    visits[4].state = visits[5].state = VisitState::Draft;
    view.setVisits(visits);
    view.setRobot(PlanRobot{{1.6, 0.9, 0.8}, 0.2});
    view.setSelectedCandidate(QStringLiteral("C-002"));
    view.resize(1300, 780);
    saveScreenshot(view, QStringLiteral("plan-1920"));
    view.setRobot(PlanRobot{{1.6, 0.9, 0.8}, 14.0});
    view.resize(760, 500);
    view.setSelectedWaypoint(QStringLiteral("W-02"));
    saveScreenshot(view, QStringLiteral("plan-1366"));
    applyTheme(*qApp, ThemeKind::Light);
    saveScreenshot(view, QStringLiteral("plan-light"));
    applyTheme(*qApp, ThemeKind::Dark);
    view.setScene({});
    view.setRobot({});
    saveScreenshot(view, QStringLiteral("plan-empty"));
    const QImage printed = planImage(planScene(tankInspection({.visited = false})), {900, 640}, ThemeKind::Light);
    EXPECT_FALSE(printed.isNull());
    const QString folder = qEnvironmentVariable("FODSCOPE_SCREENSHOTS");
    if (!folder.isEmpty()) printed.save(folder + QStringLiteral("/plan-points.png"));
}

}  // namespace
}  // namespace fodscope
