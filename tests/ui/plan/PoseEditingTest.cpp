// SPDX-License-Identifier: MIT
#include "ui/plan/PoseEditing.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <numbers>

#include "tests/fakes/PictureGrid.h"
#include "ui/plan/PlanView.h"

namespace fodscope {
namespace {

constexpr double kPi = std::numbers::pi;

InspectionState routeState() {
    InspectionState state;
    state.route.poses = {{"R-01", {1.0, 1.0, 0.0}, false}, {"R-02", {2.0, 1.5, kPi / 2.0}, true}};
    return state;
}

class RouteOnScreen : public testing::Test {
  protected:
    RouteOnScreen() {
        view.resize(800, 600);
        view.show();
        view.setScene(routeScene(state, &grid));
        view.grab();
        transform = fittedPlan(planExtent(view.scene()), QRectF(0, 0, view.width(), 100));
    }

    /// Finds where the view draws a pose by asking it what is there.
    QPoint placeOf(std::size_t index) {
        QSignalSpy selected(&view, &PlanView::waypointSelected);
        for (int y = 4; y < view.height(); y += 6) {
            for (int x = 4; x < view.width(); x += 6) {
                QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, {x, y});
                if (selected.isEmpty()) continue;
                if (selected.takeFirst().at(0).toString().toStdString() == state.route.poses[index].id) return {x, y};
            }
        }
        ADD_FAILURE() << "the pose is not on the screen";
        return {};
    }

    void drag(const QPoint& from, const QPoint& to) {
        QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, from);
        QMouseEvent move(QEvent::MouseMove, to, Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&view, &move);
        QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, to);
    }

    InspectionState state = routeState();
    OccupancyGrid grid = walledRoom(60, 50);
    PlanView view;
    PlanTransform transform;
};

TEST(PoseEditing, TheHandleTurnsAndThePoseMoves) {
    PlanTransform transform;
    transform.pixelsPerMetre = 100.0;
    transform.origin = {0.0, 400.0};
    const PlanScene scene = routeScene(routeState(), nullptr);
    const auto pose = poseGripAt(scene, transform, {100.0, 300.0});
    ASSERT_TRUE(pose);
    EXPECT_EQ(pose->waypoint, 0U);
    EXPECT_FALSE(pose->turns);
    const auto handle = poseGripAt(scene, transform, {100.0 + kTurnArm_px, 300.0});
    ASSERT_TRUE(handle);
    EXPECT_TRUE(handle->turns);
    EXPECT_FALSE(poseGripAt(scene, transform, {100.0, 200.0}));

    const Pose2 moved = draggedPose(*pose, scene.waypoints[0].pose_map, transform, {250.0, 150.0});
    EXPECT_NEAR(moved.x_m, 2.5, 1e-12);
    EXPECT_NEAR(moved.y_m, 2.5, 1e-12);
    EXPECT_EQ(moved.yaw_rad, 0.0);
    const Pose2 turned = draggedPose(*handle, scene.waypoints[0].pose_map, transform, {100.0, 100.0});
    EXPECT_EQ(turned.x_m, 1.0);
    EXPECT_NEAR(turned.yaw_rad, kPi / 2.0, 1e-12) << "up on the screen is along y";
    EXPECT_EQ(draggedPose(*handle, scene.waypoints[0].pose_map, transform, {100.0, 300.0}).yaw_rad, 0.0);
}

TEST(PoseEditing, AnAddedPoseLooksOnFromTheLastOne) {
    const PlanScene scene = routeScene(routeState(), nullptr);
    EXPECT_NEAR(addedPose(scene, {3.0, 2.5}).yaw_rad, kPi / 4.0, 1e-12);
    EXPECT_EQ(addedPose({}, {3.0, 2.5}).yaw_rad, 0.0);
}

TEST_F(RouteOnScreen, ADoubleClickBesideThePosesAddsOne) {
    QSignalSpy added(&view, &PlanView::poseAdded);
    const QPoint place = placeOf(0);
    QTest::mouseDClick(&view, Qt::LeftButton, Qt::NoModifier, place + QPoint(0, 60));
    ASSERT_EQ(added.count(), 1);
    const auto pose = added.at(0).at(0).value<Pose2>();
    EXPECT_NEAR(pose.x_m, 1.0, 0.2);
    EXPECT_LT(pose.y_m, 1.0);
    QTest::mouseDClick(&view, Qt::LeftButton, Qt::NoModifier, place);
    EXPECT_EQ(added.count(), 1) << "there is a pose already";
}

TEST_F(RouteOnScreen, ADragMovesThePoseAndNotThePlan) {
    QSignalSpy changed(&view, &PlanView::poseChanged);
    const QPoint place = placeOf(0);
    drag(place, place + QPoint(40, 0));
    ASSERT_EQ(changed.count(), 1);
    EXPECT_EQ(changed.at(0).at(0).toString(), "R-01");
    EXPECT_GT(changed.at(0).at(1).value<Pose2>().x_m, 1.1);
    EXPECT_NEAR(changed.at(0).at(1).value<Pose2>().y_m, 1.0, 0.15);
}

TEST_F(RouteOnScreen, EscapeLeavesThePoseWhereItWas) {
    QSignalSpy changed(&view, &PlanView::poseChanged);
    const QPoint place = placeOf(0);
    QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, place);
    QMouseEvent move(QEvent::MouseMove, place + QPoint(50, 50), Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&view, &move);
    QTest::keyClick(&view, Qt::Key_Escape);
    QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, place + QPoint(50, 50));
    EXPECT_TRUE(changed.isEmpty());
    EXPECT_EQ(view.scene().waypoints[0].pose_map, (Pose2{1.0, 1.0, 0.0}));
}

TEST_F(RouteOnScreen, DeleteTakesTheSelectedPoseOut) {
    QSignalSpy removed(&view, &PlanView::poseRemoved);
    QTest::keyClick(&view, Qt::Key_Delete);
    EXPECT_TRUE(removed.isEmpty()) << "none is selected";
    view.setSelectedWaypoint(QStringLiteral("R-02"));
    QTest::keyClick(&view, Qt::Key_Delete);
    ASSERT_EQ(removed.count(), 1);
    EXPECT_EQ(removed.at(0).at(0).toString(), "R-02");
}

}  // namespace
}  // namespace fodscope
