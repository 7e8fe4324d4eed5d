// SPDX-License-Identifier: MIT
// The first phase: a robot drives a route while it maps, and the map is fetched.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/common/Error.h"
#include "core/inspection/AutomaticInspection.h"
#include "core/simulation/FloorGrid.h"
#include "core/simulation/SimulatedRobot.h"
#include "tests/fakes/MemoryJournal.h"
#include "tests/fakes/ScriptedRobotLink.h"
#include "tests/unit/simulation/SmallWorlds.h"

namespace fodscope {
namespace {

DepthMappingSettings quickMapping() {
    DepthMappingSettings settings;
    settings.columns = 48;
    settings.rows = 27;
    settings.mapVoxel_m = 0.03;
    return settings;
}

class RouteDrive : public ::testing::Test {
  protected:
    RouteDrive() {
        World room = test::room();
        room.robotStart_world = {0.5, 1.0, 0.0};
        world_ = std::make_shared<const World>(room);
    }

    std::unique_ptr<RobotLink> robot() const {
        SimulatedRobotSettings settings;
        settings.waitForRendering = true;
        settings.camera.width_px = 96;
        settings.camera.height_px = 54;
        settings.mapping = quickMapping();
        return makeSimulatedRobot(world_, exploredFloor(*world_), nullptr, {}, settings);
    }

    /// Drives a route with these poses and fetches the map.
    std::shared_ptr<const PointCloud> mapOf(std::vector<RoutePose> poses) {
        inspection_ = std::make_unique<Inspection>(InspectionState(), journal_);
        InspectionRoute route;
        route.poses = std::move(poses);
        inspection_->setRoute(route);
        const auto link = robot();
        driveRoute(*link, *inspection_, progress_);
        return fetchMap(*link, progress_);
    }

    std::shared_ptr<const World> world_;
    test::MemoryJournal journal_;
    std::unique_ptr<Inspection> inspection_;
    Progress progress_;
};

double farthestX(const PointCloud& map) {
    double most = -1e9;
    for (const Eigen::Vector3d& point : map.points)
        most = std::max(most, point.x());
    return most;
}

TEST_F(RouteDrive, EveryPoseIsDrivenAndTheMapShowsWhatWasSeenFromThere) {
    const auto map = mapOf({{{}, {1.0, 1.0, 0.0}, false}, {{}, {2.2, 1.2, 1.57}, true}});
    for (const Visit& visit : inspection_->state().routeVisits)
        EXPECT_EQ(visit.state, VisitState::Done) << reasonText(visit);
    ASSERT_EQ(inspection_->state().photos.size(), 1U) << "a photo only where one was asked for";
    EXPECT_EQ(inspection_->state().photos[0].waypointId, "R-02");
    EXPECT_TRUE(inspection_->state().photos[0].candidateIds.empty());
    EXPECT_FALSE(inspection_->candidatesAreFrozen()) << "there are none yet";
    EXPECT_GT(map->size(), 500U);
    EXPECT_NEAR(farthestX(*map), 3.0, 0.15) << "the wall at the far end";
    EXPECT_EQ(std::ranges::count(journal_.acts, "route"), 1);
}

TEST_F(RouteDrive, AnotherRouteMakesAnotherMap) {
    const auto back = mapOf({{{}, {0.5, 1.0, 3.1}, false}});
    const auto forth = mapOf({{{}, {2.0, 1.0, 0.0}, false}});
    EXPECT_NE(forth->size(), back->size());
}

TEST_F(RouteDrive, APoseInAWallFailsWithItsReasonAndTheOthersAreDriven) {
    mapOf({{{}, {-5.0, 1.0, 0.0}, false}, {{}, {1.0, 1.0, 0.0}, false}});
    const std::vector<Visit>& visits = inspection_->state().routeVisits;
    EXPECT_EQ(visits[0].state, VisitState::Failed);
    EXPECT_EQ(visits[0].reason, VisitReason::Aborted);
    EXPECT_EQ(visits[1].state, VisitState::Done);
}

TEST_F(RouteDrive, ARobotThatDoesNotMapSaysSo) {
    ScriptedRobotLink link;
    link.say(LinkMessage{"no map yet"});
    EXPECT_THROW(fetchMap(link, progress_), Error);
}

TEST_F(RouteDrive, ARobotThatHoldsEndsTheDriveWithItsReason) {
    Inspection inspection({}, journal_);
    InspectionRoute route;
    route.poses = {{{}, {1.0, 1.0, 0.0}, false}};
    inspection.setRoute(route);
    ScriptedRobotLink link;
    link.say(GoalFailed{"R-01/1", GoalFailure::Preempted, "by rviz"});
    link.keepsEvents = true;
    try {
        driveRoute(link, inspection, progress_);
        FAIL() << "the drive must not end well";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("replaced by another goal: by rviz"), std::string::npos);
    }
    EXPECT_EQ(inspection.state().routeVisits[0].state, VisitState::Draft) << "to be resumed";
}

TEST(InspectionRouteOfSession, APoseThatWasDrivenAndThenMovedIsAnotherOne) {
    test::MemoryJournal journal;
    Inspection inspection({}, journal);
    InspectionRoute route;
    route.poses = {{{}, {1.0, 1.0, 0.0}, false}, {{}, {2.0, 1.0, 0.0}, false}};
    inspection.setRoute(route);
    Visit visit;
    visit.waypointId = "R-01";
    visit.state = VisitState::Done;
    visit.tries = 1;
    inspection.updateVisit(visit);
    route = inspection.state().route;
    std::swap(route.poses[0], route.poses[1]);
    route.poses[0].pose_map.x_m = 2.5;
    inspection.setRoute(route);
    EXPECT_EQ(inspection.state().route.poses[0].id, "R-02") << "not driven yet, so the same one";
    EXPECT_EQ(inspection.state().route.poses[1].id, "R-01");
    EXPECT_EQ(inspection.state().routeVisits[1].state, VisitState::Done) << "the order changes no visit";
    route = inspection.state().route;
    route.poses[1].pose_map.y_m = 0.5;
    inspection.setRoute(route);
    EXPECT_EQ(inspection.state().route.poses[1].id, "R-03");
    EXPECT_EQ(inspection.state().routeVisits[1].state, VisitState::Draft);
}

}  // namespace
}  // namespace fodscope
