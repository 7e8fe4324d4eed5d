// SPDX-License-Identifier: MIT
#include "core/simulation/SimulatedRobot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgcodecs.hpp>

#include "core/common/Error.h"
#include "core/robot/PhotoIntegrity.h"
#include "core/robot/VisitRunner.h"
#include "tests/fakes/PictureGrid.h"

namespace fodscope {
namespace {

/// A floor of 4 × 4 m with a red sheet standing at x = 3 m in the world.
std::shared_ptr<World> floorWithSheet() {
    auto world = std::make_shared<World>();
    world->structure.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
    world->structure.triangles = {{0, 1, 2}, {0, 2, 3}};
    world->structure.colours = std::vector<Rgb>(4, Rgb{120, 120, 120});
    WorldObject sheet;
    sheet.type = "sheet";
    sheet.fod = true;
    sheet.mesh.vertices = {{3, 1.8, 0.02}, {3, 2.2, 0.02}, {3, 2.2, 0.4}, {3, 1.8, 0.4}};
    sheet.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    sheet.mesh.colours = std::vector<Rgb>(4, Rgb{230, 10, 10});
    sheet.centroid_world = {3.0, 2.0, 0.2};
    world->objects.push_back(sheet);
    world->robotStart_world = {1.0, 2.0, 0.0};
    return world;
}

SimulatedRobotSettings quickSettings() {
    SimulatedRobotSettings settings;
    settings.camera.width_px = 96;
    settings.camera.height_px = 54;
    settings.waitForRendering = true;
    return settings;
}

struct Robot {
    explicit Robot(std::shared_ptr<World> world = floorWithSheet(), const OccupancyGrid& grid = walledRoom(80, 80))
        : link(makeSimulatedRobot(std::move(world), grid, nullptr, {}, quickSettings())) {
        link->connect();
        step(0.0);
    }

    void step(double duration_s) {
        now_s += duration_s;
        for (RobotEvent& event : link->poll(now_s)) {
            if (const auto* changed = std::get_if<RobotStateChanged>(&event)) {
                state = changed->state;
            } else {
                events.push_back(std::move(event));
            }
        }
    }
    /// Polls ten times a second until an event of this kind has come.
    template <typename Event>
    const Event* await(double limit_s) {
        for (const double end_s = now_s + limit_s; now_s < end_s; step(0.1)) {
            if (find<Event>() != nullptr) break;
        }
        return find<Event>();
    }
    template <typename Event>
    const Event* find() const {
        for (const RobotEvent& event : events) {
            if (const auto* found = std::get_if<Event>(&event)) return found;
        }
        return nullptr;
    }

    std::unique_ptr<RobotLink> link;
    double now_s = 50.0;
    RobotState state;
    std::vector<RobotEvent> events;
};

TEST(SimulatedRobot, startsWhereTheWorldSaysInTheMapFrame) {
    auto world = floorWithSheet();
    world->T_map_from_world = transformFromPose({0.5, -0.5, std::numbers::pi / 2.0});
    const Robot robot(world, pictureGrid(std::vector<std::string>(100, std::string(100, '.')), 0.05, {-3.0, 0.0, 0.0}));
    ASSERT_TRUE(robot.state.pose_map);
    // World (1, 2) turned by 90° is (−2, 1), then moved.
    EXPECT_NEAR(robot.state.pose_map->x_m, -1.5, 1e-12);
    EXPECT_NEAR(robot.state.pose_map->y_m, 0.5, 1e-12);
    EXPECT_NEAR(robot.state.pose_map->yaw_rad, std::numbers::pi / 2.0, 1e-12);
    EXPECT_EQ(robot.state.link, LinkState::Connected);
    EXPECT_EQ(robot.state.poseMeasured_s, 50.0);
}

TEST(SimulatedRobot, drivesInTheTimeThatDistanceAndSpeedSay) {
    Robot robot;
    robot.link->sendGoal({"G-1", {2.2, 2.0, 0.0}});
    robot.step(0.1);
    EXPECT_EQ(robot.find<GoalAccepted>(), nullptr);
    robot.step(0.11);
    ASSERT_NE(robot.find<GoalAccepted>(), nullptr);
    // 1.2 m straight ahead at 0.22 m/s after 0.2 s.
    const double duration_s = 0.2 + 1.2 / 0.22;
    robot.step(50.0 + 0.2 + 0.6 / 0.22 - robot.now_s);
    EXPECT_TRUE(robot.state.moving);
    EXPECT_EQ(robot.state.goalId, "G-1");
    EXPECT_NEAR(robot.state.pose_map->x_m, 1.6, 1e-9);
    EXPECT_NEAR(*robot.state.distanceLeft_m, 0.6, 1e-9);
    robot.step(50.0 + duration_s - 0.01 - robot.now_s);
    EXPECT_EQ(robot.find<GoalArrived>(), nullptr);
    robot.step(0.02);
    ASSERT_NE(robot.find<GoalArrived>(), nullptr);
    EXPECT_EQ(robot.find<GoalArrived>()->pose_map, (Pose2{2.2, 2.0, 0.0}));
    EXPECT_FALSE(robot.state.moving);
    EXPECT_FALSE(robot.state.goalId);
}

TEST(SimulatedRobot, aGoalInAWallIsAborted) {
    Robot robot;
    robot.link->sendGoal({"G-1", {2.0, 0.02, 0.0}});
    const auto* failed = robot.await<GoalFailed>(2.0);
    ASSERT_NE(failed, nullptr);
    EXPECT_EQ(failed->failure, GoalFailure::Aborted);
    EXPECT_FALSE(failed->message.empty());
    EXPECT_EQ(robot.state.pose_map->x_m, 1.0);
}

TEST(SimulatedRobot, aGoalThatIsNoPlaceIsRejected) {
    Robot robot;
    robot.link->sendGoal({"G-1", {std::nan(""), 1.0, 0.0}});
    const auto* failed = robot.await<GoalFailed>(2.0);
    ASSERT_NE(failed, nullptr);
    EXPECT_EQ(failed->failure, GoalFailure::Rejected);
}

TEST(SimulatedRobot, stopEndsTheDriveWhereItIs) {
    Robot robot;
    robot.link->sendGoal({"G-1", {3.0, 2.0, 0.0}});
    robot.step(2.2);
    robot.link->cancelAllGoals();
    robot.step(5.0);
    const auto* failed = robot.find<GoalFailed>();
    ASSERT_NE(failed, nullptr);
    EXPECT_EQ(failed->goalId, "G-1");
    EXPECT_EQ(failed->failure, GoalFailure::StopRequested);
    EXPECT_NEAR(robot.state.pose_map->x_m, 1.0 + 2.0 * 0.22, 1e-9);
    EXPECT_FALSE(robot.state.moving);
    EXPECT_EQ(robot.find<GoalArrived>(), nullptr);
}

TEST(SimulatedRobot, aNewGoalReplacesTheOneUnderWay) {
    Robot robot;
    robot.link->sendGoal({"G-1", {3.0, 2.0, 0.0}});
    robot.step(2.0);
    robot.link->sendGoal({"G-2", {1.0, 1.0, 0.0}});
    const auto* arrived = robot.await<GoalArrived>(60.0);
    ASSERT_NE(arrived, nullptr);
    EXPECT_EQ(arrived->goalId, "G-2");
    ASSERT_NE(robot.find<GoalFailed>(), nullptr);
    EXPECT_EQ(robot.find<GoalFailed>()->failure, GoalFailure::Preempted);
}

TEST(SimulatedRobot, photographsWhatStandsBeforeIt) {
    auto world = floorWithSheet();
    world->T_map_from_world = transformFromPose({0.1, 0.05, 0.02});
    Robot robot(world);
    const Pose2 goal_map = poseFromTransform(world->T_map_from_world * transformFromPose({2.4, 2.0, 0.0}));
    robot.link->sendGoal({"G-1", goal_map});
    ASSERT_NE(robot.await<GoalArrived>(60.0), nullptr);
    robot.link->requestPhoto("R-1");
    robot.step(0.3);
    EXPECT_EQ(robot.find<PhotoReceived>(), nullptr) << "a photo takes its time";
    robot.step(0.2);
    const auto* received = robot.find<PhotoReceived>();
    ASSERT_NE(received, nullptr);
    EXPECT_EQ(received->requestId, "R-1");
    const Photo& photo = received->photo;
    EXPECT_EQ(checkPhoto(photo.bytes).problem, "");
    EXPECT_EQ(photo.mediaType, "image/jpeg");
    EXPECT_EQ(photo.intrinsics.width_px, 96);
    EXPECT_GT(photo.taken.milliseconds, 0);
    EXPECT_TRUE(photo.T_map_from_camera.isApprox(cameraPose(goal_map, quickSettings().camera)));
    const cv::Mat image = cv::imdecode(
        cv::Mat(1, static_cast<int>(photo.bytes.size()), CV_8U, const_cast<std::byte*>(photo.bytes.data())),
        cv::IMREAD_COLOR);
    ASSERT_EQ(image.cols, 96);
    // The red sheet stands in the middle, 0.6 m ahead; beside it one looks into the dark.
    const auto middle = image.at<cv::Vec3b>(24, 48);
    EXPECT_GT(middle[2], middle[1] + 80);
    const auto side = image.at<cv::Vec3b>(24, 4);
    EXPECT_LT(std::abs(side[2] - side[1]), 40);
}

TEST(SimulatedRobot, takesPhotosOnlyWhileItStands) {
    Robot robot;
    robot.link->sendGoal({"G-1", {2.0, 2.0, 0.0}});
    robot.step(1.0);
    robot.link->requestPhoto("R-1");
    robot.step(2.0);
    EXPECT_EQ(robot.find<PhotoReceived>(), nullptr);
    const auto* received = robot.await<PhotoReceived>(30.0);
    ASSERT_NE(received, nullptr);
    ASSERT_NE(robot.find<GoalArrived>(), nullptr);
    EXPECT_TRUE(received->photo.T_map_from_camera.isApprox(cameraPose({2.0, 2.0, 0.0}, quickSettings().camera)));
}

TEST(SimulatedRobot, whoEndsTheWaitForAPhotoGetsItLater) {
    bool isOver = true;
    SimulatedRobotSettings settings = quickSettings();
    settings.isWaitOver = [&isOver] { return isOver; };
    const auto link = makeSimulatedRobot(floorWithSheet(), walledRoom(80, 80), nullptr, {}, settings);
    const auto photoOf = [](const std::vector<RobotEvent>& events) {
        return std::ranges::count_if(events, [](const RobotEvent& event) {
            return std::holds_alternative<PhotoReceived>(event) || std::holds_alternative<PhotoFailed>(event);
        });
    };
    link->connect();
    link->poll(1.0);
    link->requestPhoto("R-1");
    EXPECT_EQ(photoOf(link->poll(2.0)), 0);
    isOver = false;
    const std::vector<RobotEvent> events = link->poll(2.0);
    ASSERT_EQ(photoOf(events), 1);
    EXPECT_EQ(std::get<PhotoReceived>(events[0]).requestId, "R-1");
}

TEST(SimulatedRobot, aPhotoUnderWayIsGivenUpWithTheConnection) {
    SimulatedRobotSettings settings = quickSettings();
    // Large enough that it cannot be done when it is given up.
    settings.camera.width_px = 2048;
    settings.camera.height_px = 2048;
    settings.isWaitOver = [] { return true; };
    const auto link = makeSimulatedRobot(floorWithSheet(), walledRoom(80, 80), nullptr, {}, settings);
    link->connect();
    link->poll(1.0);
    link->requestPhoto("R-1");
    link->disconnect();
    link->connect();
    for (const RobotEvent& event : link->poll(20.0)) {
        EXPECT_FALSE(std::holds_alternative<PhotoReceived>(event));
        EXPECT_FALSE(std::holds_alternative<PhotoFailed>(event));
    }
}

TEST(SimulatedRobot, answersWithTheMapAndGridItWasGiven) {
    auto map = std::make_shared<PointCloud>();
    map->points = {{1.0, 2.0, 3.0}};
    const auto link = makeSimulatedRobot(floorWithSheet(), walledRoom(80, 80), map, {}, quickSettings());
    link->connect();
    link->requestMap();
    link->requestGrid();
    const std::vector<RobotEvent> events = link->poll(1.0);
    ASSERT_EQ(events.size(), 3U);
    EXPECT_EQ(std::get<MapReceived>(events[0]).map, map);
    EXPECT_EQ(std::get<GridReceived>(events[1]).grid.cells, walledRoom(80, 80).cells);

    Robot without;
    without.link->requestMap();
    without.step(0.1);
    EXPECT_EQ(without.find<MapReceived>(), nullptr);
    EXPECT_NE(without.find<LinkMessage>(), nullptr);
}

TEST(SimulatedRobot, saysWhenItIsNotConnected) {
    const auto link = makeSimulatedRobot(floorWithSheet(), walledRoom(80, 80), nullptr, {}, quickSettings());
    link->sendGoal({"G-1", {2.0, 2.0, 0.0}});
    link->requestPhoto("R-1");
    const std::vector<RobotEvent> events = link->poll(1.0);
    ASSERT_EQ(events.size(), 2U);
    EXPECT_EQ(std::get<GoalFailed>(events[0]).failure, GoalFailure::LinkLost);
    EXPECT_EQ(std::get<PhotoFailed>(events[1]).failure, PhotoFailure::LinkLost);
}

TEST(SimulatedRobot, refusesAPlaceItCannotStartFrom) {
    EXPECT_THROW(makeSimulatedRobot(floorWithSheet(), walledRoom(10, 10), nullptr, {}, {}), Error);
    EXPECT_THROW(makeSimulatedRobot(floorWithSheet(), OccupancyGrid{}, nullptr, {}, {}), Error);
    EXPECT_THROW(makeSimulatedRobot(nullptr, walledRoom(80, 80), nullptr, {}, {}), Error);
    SimulatedRobotSettings standing;
    standing.speed_m_per_s = 0.0;
    EXPECT_THROW(makeSimulatedRobot(floorWithSheet(), walledRoom(80, 80), nullptr, {}, standing), Error);
}

TEST(SimulatedRobot, aRunnerBringsThePhotoOfEveryCandidate) {
    Robot robot;
    CostMap costMap = inflate(walledRoom(80, 80), {});
    floodFill(costMap, *robot.state.pose_map);
    const std::vector<PlanTarget> targets{{"C-001", {3.0, 2.0, 0.2}, {0.4, 0.02, 0.4}, 0.0, {}, 0.02},
                                          {"C-002", {1.0, 3.2, 0.1}, {0.1, 0.1, 0.1}, 0.0, {}, 0.02},
                                          {"C-003", {-4.0, 0.0, 0.1}, {0.1, 0.1, 0.1}, 0.0, {}, 0.02}};
    Progress progress;
    const VisitPlan plan = planVisits(targets, costMap, costMap, *robot.state.pose_map, {}, {}, progress);
    std::vector<Visit> visits;
    for (const Waypoint& waypoint : plan.waypoints)
        visits.push_back({waypoint.id, VisitState::Draft, "", {}, "", 0, 0});
    VisitRunner runner(*robot.link, plan, visits, {});
    runner.start();
    std::vector<Photo> photos;
    for (double now_s = 60.0; now_s < 400.0 && runner.state() != RunnerState::Finished; now_s += 0.1) {
        VisitProgress now = runner.advance(now_s);
        std::move(now.photos.begin(), now.photos.end(), std::back_inserter(photos));
    }
    EXPECT_EQ(runner.state(), RunnerState::Finished);
    ASSERT_EQ(photos.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(runner.visits()[i].state, VisitState::Done);
        EXPECT_EQ(photos[i].candidateIds, plan.waypoints[i].candidateIds);
        // The camera looks at the candidate: it lies before the lens, about the middle column; the yaw that has all of
        // it in the picture need not be that of its centre.
        const auto target = std::find_if(targets.begin(), targets.end(), [&](const PlanTarget& each) {
            return each.candidateId == photos[i].candidateIds.front();
        });
        const Eigen::Vector3d seen_camera = photos[i].T_map_from_camera.inverse() * target->centroid_map;
        EXPECT_NEAR(seen_camera.x() / seen_camera.z(), 0.0, 0.3);
        EXPECT_GT(seen_camera.z(), 0.3);
    }
    EXPECT_EQ(runner.visits()[2].state, VisitState::Skipped);
}

}  // namespace
}  // namespace fodscope
