// SPDX-License-Identifier: MIT
// What the bridge does with a robot that behaves.
#include <cmath>

#include "core/robot/PhotoIntegrity.h"
#include "tests/ros/bridge/BridgeCase.h"

namespace fodscope {
namespace {

class MissionTest : public BridgeCase {};

TEST_F(MissionTest, visitsWaypointsAndBringsAPhotoOfEachWithWhereItWasTaken) {
    connectFully();
    startVisits(3);
    ASSERT_TRUE(waitForRunner(RunnerState::Finished));
    ASSERT_EQ(photos_.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(visit(i).state, VisitState::Done) << reasonText(visit(i));
        const Photo& photo = photos_[i];
        const Pose2 goal = *runner_->plan().waypoints[i].pose_map;
        // The camera stands 0.20 m over the robot's middle and looks forward.
        EXPECT_NEAR(photo.T_map_from_camera.translation().x(), goal.x_m, 0.02);
        EXPECT_NEAR(photo.T_map_from_camera.translation().y(), goal.y_m, 0.02);
        EXPECT_NEAR(photo.T_map_from_camera.translation().z(), 0.20, 1e-6);
        const Eigen::Vector3d forward = photo.T_map_from_camera.linear().col(2);
        EXPECT_NEAR(forward.x(), std::cos(goal.yaw_rad), 0.02);
        EXPECT_NEAR(forward.y(), std::sin(goal.yaw_rad), 0.02);
        EXPECT_NEAR(photo.T_map_from_camera.linear().col(1).z(), -1.0, 1e-6) << "the picture's down is the world's";
        EXPECT_EQ(photo.intrinsics.width_px, 320);
        EXPECT_EQ(photo.intrinsics.height_px, 180);
        EXPECT_DOUBLE_EQ(photo.intrinsics.fx_px, 233.0);
        EXPECT_EQ(photo.mediaType, "image/jpeg");
        EXPECT_EQ(checkPhoto(photo.bytes).problem, "");
        EXPECT_LT(std::abs(static_cast<double>(photo.taken.milliseconds - UtcTime::now().milliseconds)), 20000.0);
    }
}

TEST_F(MissionTest, rawPicturesComeAsPng) {
    auto raw = settings();
    raw.parameters["image_transport"] = "raw";
    connect(raw);
    ASSERT_TRUE(waitFor([this] { return state_ && state_->pose_map && isHeard("camera"); }));
    link_->requestPhoto("R-1");
    ASSERT_TRUE(waitForEvent<PhotoReceived>());
    EXPECT_EQ(last<PhotoReceived>()->requestId, "R-1");
    EXPECT_EQ(checkPhoto(last<PhotoReceived>()->photo.bytes).mediaType, "image/png");
}

TEST_F(MissionTest, mapGridAndTrajectoryArrive) {
    connectFully();
    link_->requestGrid();
    ASSERT_TRUE(waitForEvent<GridReceived>());
    const OccupancyGrid& grid = last<GridReceived>()->grid;
    EXPECT_EQ(grid.width, 80);
    EXPECT_EQ(grid.height, 60);
    EXPECT_DOUBLE_EQ(grid.resolution_m, static_cast<double>(0.05f));
    EXPECT_NEAR(grid.origin_map.x_m, -2.0, 1e-9);
    EXPECT_EQ(grid.at({0, 0}), Cell::Occupied);
    EXPECT_EQ(grid.at({40, 30}), Cell::Free);

    link_->requestMap();
    link_->console()->callService(RobotService::PublishMap);
    ASSERT_TRUE(waitForEvent<MapReceived>());
    const PointCloud& map = *last<MapReceived>()->map;
    EXPECT_EQ(map.size(), 200u * 150u + 200u * 24u);
    EXPECT_EQ(map.colours.size(), map.size());
    EXPECT_EQ(map.colours.front().red, 0x80);
    EXPECT_NEAR(map.points.front().x(), -2.0, 1e-6);
    EXPECT_TRUE(waitFor([this] { return link_->console()->trajectory_map().size() == 5; }));
}

TEST_F(MissionTest, updatesOfTheCostMapAreApplied) {
    auto onCostMap = settings();
    onCostMap.parameters["grid"] = "/no_such_grid";
    connect(onCostMap);
    ASSERT_TRUE(waitFor([this] { return isHeard("cost map"); }));
    order(R"({"send": "costmap update"})");
    const auto isUpdated = [this] {
        if (last<GridReceived>() && last<GridReceived>()->grid.at({3, 3}) == Cell::Occupied) return true;
        link_->requestGrid();
        return false;
    };
    ASSERT_TRUE(waitFor(isUpdated));
    const OccupancyGrid& grid = last<GridReceived>()->grid;
    EXPECT_EQ(grid.at({2, 3}), Cell::Occupied);
    EXPECT_EQ(grid.at({4, 3}), Cell::Free);
    // 99 are the surroundings of an obstacle, not one.
    EXPECT_EQ(grid.at({0, 5}), Cell::Free);
}

TEST_F(MissionTest, topicsAreListedWithTheirTypes) {
    connectFully();
    const auto has = [this](const std::string& name, const std::string& type) {
        for (const RobotTopic& topic : link_->console()->topics())
            if (topic.name == name && topic.type == type) return true;
        return false;
    };
    link_->console()->requestTopics();
    ASSERT_TRUE(waitFor([&] { return has("/rtabmap/cloud_map", "sensor_msgs/PointCloud2"); }));
    EXPECT_TRUE(has("/camera/color/image_raw/compressed", "sensor_msgs/CompressedImage"));
    EXPECT_TRUE(has("/move_base/status", "actionlib_msgs/GoalStatusArray"));
}

TEST_F(MissionTest, servicesAreCalledOnlyWhenAskedFor) {
    connectFully();
    link_->console()->callService(RobotService::LocalizationMode);
    const auto called = robot_->waitForEvent("service");
    ASSERT_FALSE(called.is_null());
    EXPECT_EQ(called["name"], "set_mode_localization");
    EXPECT_TRUE(waitFor([this] { return hasMessage("set_mode_localization"); }));
}

TEST_F(MissionTest, stopCancelsEverybodysGoalsAndTellsWhenTheRobotStands) {
    connectFully();
    order(R"({"goals": "stuck"})");
    link_->sendGoal({"G-1", {1.0, 1.0, 0.0}});
    ASSERT_TRUE(waitForEvent<GoalAccepted>());
    order(R"({"send": "foreign goal"})");
    ASSERT_TRUE(waitForEvent<GoalFailed>());
    EXPECT_EQ(last<GoalFailed>()->failure, GoalFailure::Preempted);
    RobotConsole& console = *link_->console();
    ASSERT_TRUE(waitFor([&] { return console.isAnyGoalUnderWay() && console.isMoving().value_or(false); }));
    link_->cancelAllGoals();
    EXPECT_TRUE(waitFor([&] { return !console.isAnyGoalUnderWay(); }));
    EXPECT_TRUE(waitFor([&] { return console.stillFor_s().value_or(0.0) > 0.2; }));
    EXPECT_FALSE(*console.isMoving());
}

TEST_F(MissionTest, drivingByHandIsHeldToItsLimitsAndEndsWithTheKey) {
    connectFully();
    robot_->waitForEvent("velocity", 0.0);
    // Held for a moment, then let go: nothing is sent any more.
    const double until_s = now_s() + 0.5;
    waitFor([&] {
        if (now_s() < until_s) link_->console()->drive(5.0, -9.0);
        return now_s() >= until_s;
    });
    auto velocity = robot_->waitForEvent("velocity");
    ASSERT_FALSE(velocity.is_null());
    EXPECT_DOUBLE_EQ(velocity["linear"], 0.15);
    EXPECT_DOUBLE_EQ(velocity["angular"], -0.6);
    velocity = robot_->waitForEvent("velocity");
    ASSERT_FALSE(velocity.is_null());
    EXPECT_EQ(velocity["linear"], 0.0);
    EXPECT_EQ(velocity["angular"], 0.0);
}

TEST_F(MissionTest, drivingByHandEndsWhenTheWorkstationIsGone) {
    connectFully();
    link_->console()->drive(0.1, 0.0);
    ASSERT_FALSE(robot_->waitForEvent("velocity").is_null());
    link_.reset();
    const auto velocity = robot_->waitForEvent("velocity");
    ASSERT_FALSE(velocity.is_null());
    EXPECT_EQ(velocity["linear"], 0.0);
}

}  // namespace
}  // namespace fodscope
