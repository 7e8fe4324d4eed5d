// SPDX-License-Identifier: MIT
#include "ui/plan/PlanGeometry.h"

#include <gtest/gtest.h>

#include <QLineF>

#include "tests/fakes/PictureGrid.h"
#include "tests/fakes/TankInspection.h"

namespace fodscope {
namespace {

const QRectF kArea(0, 0, 800, 600);

PlanScene roomScene() {
    PlanScene scene;
    auto map = std::make_shared<CostMap>();
    map->grid = walledRoom(60, 40);
    scene.costMap = map;
    return scene;
}

void addCandidate(PlanScene& scene, const std::string& id, const Eigen::Vector2d& centroid_map) {
    PlanCandidate candidate;
    candidate.id = id;
    candidate.centroid_map = centroid_map;
    scene.candidates.push_back(candidate);
}

TEST(PlanTransform, YPointsUpAndBothWaysAgree) {
    const PlanTransform transform{200.0, {100, 500}};
    EXPECT_EQ(transform.toScreen({1.0, 2.0}), QPointF(300, 100));
    EXPECT_TRUE(transform.toMap({300, 100}).isApprox(Eigen::Vector2d(1.0, 2.0)));
}

TEST(FittedPlan, ShowsTheWholeExtent) {
    const PlanExtent extent = planExtent(roomScene());
    EXPECT_TRUE(extent.maximum_map.isApprox(Eigen::Vector2d(3.0, 2.0)));
    const PlanTransform transform = fittedPlan(extent, kArea);
    for (const Eigen::Vector2d& corner : {extent.minimum_map, extent.maximum_map}) {
        EXPECT_TRUE(kArea.contains(transform.toScreen(corner)));
    }
    const QPointF middle = transform.toScreen({1.5, 1.0});
    EXPECT_NEAR(middle.x(), 400, 1e-6);
    EXPECT_NEAR(middle.y(), 300, 1e-6);
}

TEST(FittedPlan, OfASinglePointOrNothingIsFinite) {
    PlanExtent extent;
    EXPECT_EQ(fittedPlan(extent, kArea).origin, kArea.center());
    extent.add({3, 4});
    EXPECT_LE(fittedPlan(extent, kArea).pixelsPerMetre, 5000.0);
}

TEST(ZoomedPlan, KeepsThePlaceUnderTheCursor) {
    const PlanTransform transform = fittedPlan(planExtent(roomScene()), kArea);
    const Eigen::Vector2d place = transform.toMap({120, 340});
    EXPECT_TRUE(zoomedPlan(transform, 1.7, {120, 340}).toMap({120, 340}).isApprox(place));
}

TEST(GridToScreen, PutsCellsWhereTheGridSays) {
    OccupancyGrid grid = walledRoom(20, 10);
    grid.origin_map = {1.0, -2.0, 0.4};
    const PlanTransform transform{150.0, {300, 200}};
    for (const CellIndex index : {CellIndex{0, 0}, CellIndex{7, 3}, CellIndex{19, 9}}) {
        const QPointF expected = transform.toScreen(grid.centreOf(index));
        const QPointF found = gridToScreen(grid, transform).map(QPointF(index.column + 0.5, index.row + 0.5));
        EXPECT_NEAR(found.x(), expected.x(), 1e-6);
        EXPECT_NEAR(found.y(), expected.y(), 1e-6);
    }
}

TEST(DiscCentres, WaypointsAtOnePlaceDoNotCoverEachOther) {
    PlanScene scene;
    for (int number = 1; number <= 5; ++number) {
        PlanWaypoint waypoint;
        waypoint.number = number;
        waypoint.pose_map = {1.0, 1.0, 0.3};
        scene.waypoints.push_back(waypoint);
    }
    const auto discs = discCentres(scene, {100, {0, 300}});
    EXPECT_EQ(discs[0], QPointF(100, 200));
    for (std::size_t a = 0; a < discs.size(); ++a) {
        for (std::size_t b = a + 1; b < discs.size(); ++b) {
            EXPECT_GE(QLineF(discs[a], discs[b]).length(), 2 * kWaypointDisc_px - 2.1);
        }
    }
}

TEST(PlanHitTest, FindsTheNearestAndPrefersWaypoints) {
    PlanScene scene;
    addCandidate(scene, "C-001", {1, 1});
    addCandidate(scene, "C-002", {1.2, 1});
    PlanWaypoint waypoint;
    waypoint.id = "W-01";
    waypoint.pose_map = {1.0, 1.5, 0.0};
    scene.waypoints.push_back(waypoint);
    const PlanTransform transform{100, {0, 300}};
    EXPECT_EQ(planHit(scene, transform, {103, 200}).id, "C-001");
    EXPECT_EQ(planHit(scene, transform, {118, 200}).id, "C-002");
    EXPECT_EQ(planHit(scene, transform, {100, 150}).id, "W-01");
    EXPECT_EQ(planHit(scene, transform, {300, 50}).item, PlanItem::None);
    scene.waypoints[0].pose_map = {1.0, 1.0, 0.0};
    EXPECT_EQ(planHit(scene, transform, {101, 200}).id, "W-01");
}

TEST(ScaleBar, IsARoundLengthThatFits) {
    EXPECT_DOUBLE_EQ(scaleBarLength(100.0, 160.0), 1.0);
    EXPECT_DOUBLE_EQ(scaleBarLength(100.0, 60.0), 0.5);
    EXPECT_DOUBLE_EQ(scaleBarLength(10.0, 100.0), 10.0);
    EXPECT_DOUBLE_EQ(scaleBarLength(1000.0, 45.0), 0.02);
    EXPECT_EQ(lengthInWords(0.5), "50 cm");
    EXPECT_EQ(lengthInWords(2.0), "2 m");
}

TEST(PlaceLabel, AvoidsWhatIsTakenAndStaysInside) {
    std::vector<QRectF> taken;
    for (int label = 0; label < 6; ++label) {
        const QRectF place = placeLabel({400, 300}, 8.0, {50, 18}, taken, kArea);
        EXPECT_TRUE(kArea.contains(place));
        for (const QRectF& other : taken)
            EXPECT_FALSE(other.intersects(place));
        taken.push_back(place);
    }
    EXPECT_TRUE(kArea.contains(placeLabel({795, 5}, 8.0, {50, 18}, {}, kArea)));
}

TEST(PlanSceneOf, TellsWhyACandidateHasNoWaypoint) {
    const PlanScene scene = planScene(tankInspection());
    ASSERT_TRUE(scene.costMap);
    EXPECT_EQ(scene.candidates.size(), 8U);
    EXPECT_EQ(scene.candidates.back().id, "C-008");
    EXPECT_FALSE(scene.candidates.back().noWaypointReason.empty());
    EXPECT_TRUE(scene.candidates.front().noWaypointReason.empty());
    for (std::size_t index = 0; index < scene.waypoints.size(); ++index) {
        EXPECT_EQ(scene.waypoints[index].number, static_cast<int>(index) + 1);
        EXPECT_EQ(scene.waypoints[index].state, VisitState::Done);
    }
}

TEST(PlanSceneOf, WithoutAGridShowsTheMapFromAbove) {
    const InspectionState state = tankInspection({.visited = false});
    const PlanScene scene = planScene(state);
    EXPECT_FALSE(scene.costMap);
    ASSERT_EQ(scene.pointsFromAbove_map.size(), state.detection->field->size());
    const PlanExtent extent = planExtent(scene);
    // The tank is 3.2 × 2.6 m in the map frame, not in the turned reference frame.
    EXPECT_NEAR(extent.maximum_map.x() - extent.minimum_map.x(), 3.2, 0.05);
    EXPECT_NEAR(extent.maximum_map.y() - extent.minimum_map.y(), 2.6, 0.05);
    EXPECT_TRUE(planExtent(planScene({})).empty);
}

}  // namespace
}  // namespace fodscope
