// SPDX-License-Identifier: MIT
#include "core/robot/VisitRunner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/common/Error.h"
#include "tests/fakes/ScriptedRobotLink.h"

namespace fodscope {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

VisitPlan planOf(int waypoints) {
    VisitPlan plan;
    for (int i = 1; i <= waypoints; ++i) {
        Waypoint waypoint;
        waypoint.id = "W-0" + std::to_string(i);
        waypoint.candidateIds = {"C-00" + std::to_string(i)};
        waypoint.pose_map = Pose2{0.5 * i, 1.0, 0.1};
        waypoint.status = WaypointStatus::Ok;
        plan.waypoints.push_back(waypoint);
    }
    return plan;
}

std::vector<Visit> draftsOf(const VisitPlan& plan) {
    std::vector<Visit> visits;
    for (const Waypoint& waypoint : plan.waypoints)
        visits.push_back({waypoint.id, VisitState::Draft, "", {}, "", 0, 0});
    return visits;
}

/// A runner with its link and a clock of its own.
struct Mission {
    explicit Mission(int waypoints = 2) : Mission(planOf(waypoints)) {}
    explicit Mission(const VisitPlan& plan) : runner(link, plan, draftsOf(plan), VisitSettings{}) {}

    /// A tenth of a second later.
    void step() { wait(0.1); }
    /// Two calls of advance: what the first decides to send leaves with the second.
    void wait(double duration_s) {
        now_s += duration_s;
        advance();
        advance();
    }
    void advance() {
        VisitProgress progress = runner.advance(now_s);
        std::move(progress.changedVisits.begin(), progress.changedVisits.end(), std::back_inserter(changes));
        std::move(progress.photos.begin(), progress.photos.end(), std::back_inserter(photos));
        std::move(progress.messages.begin(), progress.messages.end(), std::back_inserter(messages));
        std::move(progress.otherEvents.begin(), progress.otherEvents.end(), std::back_inserter(otherEvents));
        if (progress.robot) robot = progress.robot;
    }
    /// What a robot that behaves says to the visit under way, to its end.
    void behave() {
        link.accept();
        step();
        link.arrive();
        step();
        link.sendPhoto();
        step();
    }
    VisitState stateOf(std::size_t index) const { return runner.visits()[index].state; }
    std::string reasonOf(std::size_t index) const { return reasonText(runner.visits()[index]); }
    std::vector<VisitState> statesSeen() const {
        std::vector<VisitState> states;
        for (const Visit& visit : changes)
            states.push_back(visit.state);
        return states;
    }

    ScriptedRobotLink link;
    VisitRunner runner;
    double now_s = 100.0;
    std::vector<Visit> changes;
    std::vector<Photo> photos;
    std::vector<std::string> messages;
    std::vector<RobotEvent> otherEvents;
    std::optional<RobotState> robot;
};

TEST(VisitRunner, doesNothingBeforeTheStart) {
    Mission mission;
    mission.wait(1000.0);
    EXPECT_EQ(mission.runner.state(), RunnerState::Idle);
    EXPECT_TRUE(mission.link.goals.empty());
    EXPECT_TRUE(mission.changes.empty());
}

TEST(VisitRunner, drivesThePlanInOrderAndHandsOverThePhotos) {
    Mission mission;
    mission.runner.start();
    mission.step();
    ASSERT_EQ(mission.link.goals.size(), 1U);
    EXPECT_EQ(mission.link.goals[0].pose_map, (Pose2{0.5, 1.0, 0.1}));
    mission.link.accept();
    mission.step();
    mission.link.report(LinkState::Connected, mission.link.goals[0].id, true);
    mission.step();
    EXPECT_TRUE(mission.link.photoRequests.empty()) << "no photo before the arrival";
    mission.link.arrive();
    mission.step();
    ASSERT_EQ(mission.link.photoRequests.size(), 1U);
    mission.link.sendPhoto();
    mission.step();
    EXPECT_THAT(mission.statesSeen(),
                ElementsAre(VisitState::Sent, VisitState::Accepted, VisitState::Driving, VisitState::Arrived,
                            VisitState::Photo, VisitState::Done, VisitState::Sent));
    ASSERT_EQ(mission.photos.size(), 1U);
    EXPECT_EQ(mission.photos[0].waypointId, "W-01");
    EXPECT_THAT(mission.photos[0].candidateIds, ElementsAre("C-001"));
    EXPECT_EQ(mission.photos[0].mediaType, "image/jpeg");
    EXPECT_EQ(mission.photos[0].bytes, photoBytes(".jpg", 1));
    EXPECT_EQ(mission.photos[0].requestId, "W-01/1/photo-1");

    ASSERT_EQ(mission.link.goals.size(), 2U);
    EXPECT_NE(mission.link.goals[0].id, mission.link.goals[1].id);
    mission.behave();
    EXPECT_EQ(mission.runner.state(), RunnerState::Finished);
    EXPECT_EQ(mission.link.cancels, 0);
    EXPECT_EQ(mission.photos.size(), 2U);
}

TEST(VisitRunner, anEmptyPlanIsFinishedAtOnce) {
    Mission mission(0);
    mission.runner.start();
    mission.step();
    EXPECT_EQ(mission.runner.state(), RunnerState::Finished);
}

TEST(VisitRunner, waypointsWithoutAPoseAreSkippedWithTheirReason) {
    VisitPlan plan = planOf(2);
    plan.waypoints[0].pose_map.reset();
    plan.waypoints[0].status = WaypointStatus::Hidden;
    Mission mission(plan);
    mission.runner.start();
    mission.step();
    EXPECT_EQ(mission.stateOf(0), VisitState::Skipped);
    EXPECT_EQ(mission.reasonOf(0), "no waypoint: hidden");
    EXPECT_EQ(mission.stateOf(1), VisitState::Sent);
}

/// What may go wrong with every try of a drive, and what becomes of the visit.
struct DriveFault {
    std::string name;
    std::function<void(Mission&)> fault;
    std::string reason;
    int cancels;
};

class DriveFaults : public testing::TestWithParam<DriveFault> {};

TEST_P(DriveFaults, areTriedAgainThenFailAndTheNextVisitBegins) {
    Mission mission;
    mission.runner.start();
    mission.step();
    GetParam().fault(mission);
    EXPECT_EQ(mission.stateOf(0), VisitState::Draft) << "pause before the second try";
    EXPECT_EQ(mission.reasonOf(0), GetParam().reason);
    mission.wait(1.0);
    EXPECT_EQ(mission.stateOf(0), VisitState::Sent) << "second try";
    ASSERT_EQ(mission.link.goals.size(), 2U);
    EXPECT_NE(mission.link.goals[0].id, mission.link.goals[1].id);
    EXPECT_EQ(mission.link.cancels, 0);
    GetParam().fault(mission);
    EXPECT_EQ(mission.stateOf(0), VisitState::Failed);
    EXPECT_EQ(mission.reasonOf(0), GetParam().reason);
    EXPECT_EQ(mission.runner.visits()[0].tries, 2);
    EXPECT_EQ(mission.link.cancels, GetParam().cancels);
    mission.wait(1.0);
    EXPECT_EQ(mission.stateOf(1), VisitState::Sent);
    mission.behave();
    EXPECT_EQ(mission.stateOf(1), VisitState::Done);
    EXPECT_EQ(mission.runner.state(), RunnerState::Finished);
}

INSTANTIATE_TEST_SUITE_P(VisitRunner, DriveFaults,
                         testing::Values(DriveFault{"notAcknowledged", [](Mission& mission) { mission.wait(3.1); },
                                                    "not confirmed by the robot", 1},
                                         DriveFault{"late",
                                                    [](Mission& mission) {
                                                        mission.link.accept();
                                                        mission.wait(2.9);
                                                        mission.wait(119.0);
                                                        EXPECT_EQ(mission.stateOf(0), VisitState::Accepted);
                                                        mission.wait(1.1);
                                                    },
                                                    "not arrived in time", 1},
                                         DriveFault{"aborted",
                                                    [](Mission& mission) {
                                                        mission.link.accept();
                                                        mission.link.fail(GoalFailure::Aborted, "no path");
                                                        mission.step();
                                                    },
                                                    "given up by the robot: no path", 0},
                                         DriveFault{"rejected",
                                                    [](Mission& mission) {
                                                        mission.link.fail(GoalFailure::Rejected);
                                                        mission.step();
                                                    },
                                                    "rejected by the robot", 0}),
                         [](const auto& info) { return info.param.name; });

struct PhotoFault {
    std::string name;
    std::function<void(Mission&)> fault;
    std::string reason;
};

class PhotoFaults : public testing::TestWithParam<PhotoFault> {};

TEST_P(PhotoFaults, areAskedForAgainThenTheVisitFails) {
    Mission mission;
    mission.runner.start();
    mission.step();
    mission.link.arrive();
    mission.step();
    GetParam().fault(mission);
    EXPECT_EQ(mission.stateOf(0), VisitState::Photo);
    EXPECT_EQ(mission.reasonOf(0), GetParam().reason);
    mission.wait(1.0);
    ASSERT_EQ(mission.link.photoRequests.size(), 2U);
    EXPECT_NE(mission.link.photoRequests[0], mission.link.photoRequests[1]);
    GetParam().fault(mission);
    EXPECT_EQ(mission.stateOf(0), VisitState::Failed);
    EXPECT_EQ(mission.reasonOf(0), GetParam().reason);
    EXPECT_TRUE(mission.photos.empty());
    EXPECT_EQ(mission.link.goals.size(), 2U) << "the next visit has begun";
}

TEST_P(PhotoFaults, aGoodSecondPhotoIsTaken) {
    Mission mission;
    mission.runner.start();
    mission.step();
    mission.link.arrive();
    mission.step();
    GetParam().fault(mission);
    mission.wait(1.0);
    mission.link.sendPhoto();
    mission.step();
    EXPECT_EQ(mission.stateOf(0), VisitState::Done);
    EXPECT_EQ(mission.photos.size(), 1U);
}

void sendBytes(Mission& mission, std::vector<std::byte> bytes) {
    mission.link.sendPhoto(mission.link.photoRequests.back(), std::move(bytes));
    mission.step();
}

INSTANTIATE_TEST_SUITE_P(
    VisitRunner, PhotoFaults,
    testing::Values(
        PhotoFault{"late", [](Mission& mission) { mission.wait(10.1); }, "no photo in time"},
        PhotoFault{"missing",
                   [](Mission& mission) {
                       mission.link.say(PhotoFailed{mission.link.photoRequests.back(), PhotoFailure::Missing, "dark"});
                       mission.step();
                   },
                   "the robot has no photo: dark"},
        PhotoFault{"empty", [](Mission& mission) { sendBytes(mission, {}); }, "the photo is damaged: it has no bytes"},
        PhotoFault{"foreign", [](Mission& mission) { sendBytes(mission, std::vector<std::byte>(99, std::byte{7})); },
                   "the photo is damaged: it is neither a JPEG nor a PNG image"},
        PhotoFault{"cutOff",
                   [](Mission& mission) {
                       auto bytes = photoBytes();
                       bytes.resize(bytes.size() / 2);
                       sendBytes(mission, bytes);
                   },
                   "the photo is damaged: it is cut off"}),
    [](const auto& info) { return info.param.name; });

/// What makes the runner hold for a person, with the visit open again.
struct HoldCause {
    std::string name;
    std::function<void(Mission&)> cause;
    std::string reason;
};

class HoldCauses : public testing::TestWithParam<HoldCause> {};

TEST_P(HoldCauses, leaveTheVisitOpenUntilSomebodyResumes) {
    Mission mission;
    mission.runner.start();
    mission.step();
    mission.link.accept();
    mission.step();
    GetParam().cause(mission);
    mission.step();
    EXPECT_EQ(mission.runner.state(), RunnerState::Paused);
    EXPECT_EQ(mission.stateOf(0), VisitState::Draft);
    EXPECT_THAT(mission.reasonOf(0), HasSubstr(GetParam().reason));
    mission.link.report(LinkState::Connected);
    mission.wait(500.0);
    EXPECT_EQ(mission.link.goals.size(), 1U) << "nothing happens by itself";
    mission.runner.start();
    mission.step();
    EXPECT_EQ(mission.link.goals.size(), 2U);
    mission.behave();
    EXPECT_EQ(mission.stateOf(0), VisitState::Done);
    EXPECT_EQ(mission.stateOf(1), VisitState::Sent);
}

INSTANTIATE_TEST_SUITE_P(
    VisitRunner, HoldCauses,
    testing::Values(
        HoldCause{"linkLost",
                  [](Mission& mission) {
                      mission.link.report(LinkState::Lost);
                      mission.wait(1.0);
                      EXPECT_EQ(mission.stateOf(0), VisitState::Accepted) << "it may come back";
                      mission.wait(15.1);
                  },
                  "link lost"},
        HoldCause{"disconnected",
                  [](Mission& mission) {
                      mission.link.report(LinkState::Disconnected);
                      mission.wait(1.0);
                      mission.wait(15.1);
                  },
                  "link lost"},
        HoldCause{"goalLinkLost",
                  [](Mission& mission) {
                      mission.link.fail(GoalFailure::LinkLost);
                      mission.wait(1.0);
                      mission.wait(15.1);
                  },
                  "link lost"},
        HoldCause{"preempted", [](Mission& mission) { mission.link.fail(GoalFailure::Preempted, "by rviz"); },
                  "replaced by another goal: by rviz"},
        HoldCause{"stoppedAtTheRobot", [](Mission& mission) { mission.link.fail(GoalFailure::StopRequested); },
                  "stopped at the robot"},
        HoldCause{"photoLinkLost",
                  [](Mission& mission) {
                      mission.link.arrive();
                      mission.step();
                      mission.link.say(PhotoFailed{mission.link.photoRequests.back(), PhotoFailure::LinkLost, ""});
                      mission.wait(1.0);
                      mission.wait(15.1);
                  },
                  "link lost"}),
    [](const auto& info) { return info.param.name; });

TEST(VisitRunner, sendsNothingWhileTheLinkIsDown) {
    Mission mission;
    mission.link.report(LinkState::Lost);
    mission.step();
    mission.runner.start();
    mission.wait(60.0);
    EXPECT_TRUE(mission.link.goals.empty());
    mission.link.report(LinkState::Connecting);
    mission.step();
    EXPECT_TRUE(mission.link.goals.empty());
    mission.link.report(LinkState::Connected);
    mission.step();
    EXPECT_EQ(mission.link.goals.size(), 1U);
}

TEST(VisitRunner, whatTheRobotSaysAboutOtherGoalsChangesNothing) {
    Mission mission;
    mission.runner.start();
    mission.step();
    const std::string firstTry = mission.link.goals[0].id;
    for (const std::string stranger : {"", "W-99/1", "move_base-7"}) {
        mission.link.say(GoalAccepted{stranger});
        mission.link.say(GoalArrived{stranger, {}});
        mission.link.say(GoalFailed{stranger, GoalFailure::Aborted, ""});
    }
    mission.step();
    EXPECT_EQ(mission.stateOf(0), VisitState::Sent);
    mission.wait(3.0);
    mission.wait(1.0);
    ASSERT_EQ(mission.link.goals.size(), 2U);
    // The first try ends when the second one comes.
    mission.link.say(GoalFailed{firstTry, GoalFailure::Preempted, ""});
    mission.step();
    EXPECT_EQ(mission.stateOf(0), VisitState::Sent);
    EXPECT_EQ(mission.runner.state(), RunnerState::Running);
    EXPECT_TRUE(mission.link.photoRequests.empty());
}

TEST(VisitRunner, aDoubledArrivalAsksForOnePhoto) {
    Mission mission;
    mission.runner.start();
    mission.step();
    mission.link.arrive();
    mission.link.arrive();
    mission.step();
    mission.link.arrive();
    mission.link.fail(GoalFailure::Aborted);
    mission.step();
    EXPECT_EQ(mission.link.photoRequests.size(), 1U);
    EXPECT_EQ(mission.stateOf(0), VisitState::Photo);
}

TEST(VisitRunner, anArrivalIsAcceptanceToo) {
    Mission mission;
    mission.runner.start();
    mission.step();
    mission.link.arrive();
    mission.step();
    EXPECT_THAT(mission.statesSeen(), ElementsAre(VisitState::Sent, VisitState::Arrived, VisitState::Photo));
}

TEST(VisitRunner, theGoalInTheRobotsStatusIsAcceptance) {
    Mission mission;
    mission.runner.start();
    mission.step();
    mission.link.report(LinkState::Connected, mission.link.goals[0].id, true);
    mission.step();
    EXPECT_EQ(mission.stateOf(0), VisitState::Driving);
    mission.wait(3.0);
    EXPECT_EQ(mission.stateOf(0), VisitState::Driving);
}

TEST(VisitRunner, aLatePhotoForAnotherRequestIsLeftOut) {
    Mission mission;
    mission.runner.start();
    mission.step();
    mission.link.arrive();
    mission.step();
    mission.link.sendPhoto("W-99/1/photo-1", photoBytes());
    mission.step();
    EXPECT_TRUE(mission.photos.empty());
    EXPECT_EQ(mission.stateOf(0), VisitState::Photo);
    mission.link.sendPhoto();
    mission.step();
    EXPECT_EQ(mission.photos.size(), 1U);
    mission.link.sendPhoto();
    mission.step();
    EXPECT_EQ(mission.photos.size(), 1U) << "the same photo twice";
    EXPECT_EQ(mission.stateOf(1), VisitState::Sent);
}

TEST(VisitRunner, pauseLetsTheVisitUnderWayEnd) {
    Mission mission;
    mission.runner.start();
    mission.step();
    mission.runner.pause();
    EXPECT_EQ(mission.runner.state(), RunnerState::Paused);
    mission.behave();
    mission.wait(50.0);
    EXPECT_EQ(mission.stateOf(0), VisitState::Done);
    EXPECT_EQ(mission.stateOf(1), VisitState::Draft);
    EXPECT_EQ(mission.link.cancels, 0);
    EXPECT_EQ(mission.link.goals.size(), 1U);
    mission.runner.start();
    mission.step();
    EXPECT_EQ(mission.stateOf(1), VisitState::Sent);
}

TEST(VisitRunner, skipGivesUpTheVisitUnderWayAndGoesOn) {
    Mission mission;
    mission.runner.start();
    mission.step();
    mission.link.accept();
    mission.step();
    mission.runner.skip();
    EXPECT_EQ(mission.link.cancels, 1);
    EXPECT_EQ(mission.stateOf(0), VisitState::Skipped);
    mission.step();
    EXPECT_EQ(mission.link.goals.size(), 1U) << "the cancel on its way would take a new goal with it";
    mission.wait(1.0);
    EXPECT_EQ(mission.link.goals.size(), 2U);
    EXPECT_EQ(mission.stateOf(1), VisitState::Sent);
}

TEST(VisitRunner, skipWithNothingUnderWayChangesNothing) {
    Mission mission;
    mission.runner.skip();
    mission.step();
    EXPECT_EQ(mission.link.cancels, 0);
    EXPECT_TRUE(mission.changes.empty());
}

TEST(VisitRunner, stopCancelsAtOnceAndHolds) {
    Mission mission;
    mission.runner.start();
    mission.step();
    mission.link.accept();
    mission.step();
    mission.runner.stop();
    EXPECT_EQ(mission.link.cancels, 1) << "without waiting for the next advance";
    EXPECT_EQ(mission.runner.state(), RunnerState::Paused);
    mission.link.arrive();
    mission.wait(300.0);
    EXPECT_EQ(mission.stateOf(0), VisitState::Draft);
    EXPECT_EQ(mission.link.goals.size(), 1U);
    EXPECT_TRUE(mission.link.photoRequests.empty());
    mission.runner.start();
    mission.wait(1.0);
    EXPECT_EQ(mission.stateOf(0), VisitState::Sent) << "resume begins with the visit that was stopped";
}

TEST(VisitRunner, stopAlsoCancelsWhenNothingIsUnderWay) {
    Mission mission;
    mission.runner.stop();
    EXPECT_EQ(mission.link.cancels, 1);
    EXPECT_EQ(mission.runner.state(), RunnerState::Idle);
}

TEST(VisitRunner, stopIsSentAgainWhileTheRobotStillNamesTheGoal) {
    Mission mission;
    mission.runner.start();
    mission.step();
    const std::string goal = mission.link.goals[0].id;
    mission.runner.stop();
    for (int i = 0; i < 35; ++i) {
        mission.link.report(LinkState::Connected, goal, true);
        mission.step();
    }
    EXPECT_EQ(mission.link.cancels, 2);
    mission.link.report(LinkState::Connected);
    mission.wait(10.0);
    EXPECT_EQ(mission.link.cancels, 2);
}

TEST(VisitRunner, retryDrivesAFailedVisitAgain) {
    Mission mission(1);
    mission.runner.start();
    mission.step();
    for (int i = 0; i < 2; ++i) {
        mission.link.fail(GoalFailure::Aborted);
        mission.step();
        mission.wait(1.0);
    }
    EXPECT_EQ(mission.runner.state(), RunnerState::Finished);
    mission.runner.retry("W-01");
    EXPECT_EQ(mission.stateOf(0), VisitState::Draft);
    mission.wait(10.0);
    EXPECT_EQ(mission.link.goals.size(), 2U) << "only after start()";
    mission.runner.start();
    mission.step();
    ASSERT_EQ(mission.link.goals.size(), 3U);
    EXPECT_NE(mission.link.goals[2].id, mission.link.goals[1].id);
    mission.behave();
    EXPECT_EQ(mission.stateOf(0), VisitState::Done);
    mission.runner.retry("W-01");
    mission.runner.start();
    mission.step();
    mission.behave();
    EXPECT_EQ(mission.photos.size(), 2U) << "a visit that is done can be photographed again";
    EXPECT_THROW(mission.runner.retry("W-77"), Error);
}

TEST(VisitRunner, retryLeavesAVisitUnderWayAlone) {
    Mission mission;
    mission.runner.start();
    mission.step();
    mission.runner.retry("W-01");
    EXPECT_EQ(mission.stateOf(0), VisitState::Sent);
}

TEST(VisitRunner, resumesARecordedMissionAtTheFirstVisitNotDone) {
    const VisitPlan plan = planOf(4);
    std::vector<Visit> visits = draftsOf(plan);
    visits[0].state = VisitState::Done;
    visits[1].state = VisitState::Failed;
    visits[2] = {"W-03", VisitState::Driving, "W-03/1", {}, "", 1, 0};
    ScriptedRobotLink link;
    VisitRunner runner(link, plan, visits, {});
    EXPECT_EQ(runner.visits()[2].state, VisitState::Draft);
    EXPECT_EQ(runner.visits()[2].reason, VisitReason::Interrupted);
    runner.start();
    runner.advance(1.0);
    runner.advance(2.0);
    EXPECT_TRUE(link.goals.empty()) << "the robot may still work on the recorded goal and say so";
    runner.advance(4.0);
    runner.advance(4.1);
    ASSERT_EQ(link.goals.size(), 1U);
    EXPECT_EQ(link.goals[0].id, "W-03/2");
}

TEST(VisitRunner, passesOnWhatElseTheRobotSays) {
    Mission mission;
    mission.link.say(LinkMessage{"battery low"});
    mission.link.say(GridReceived{});
    mission.link.say(MapReceived{});
    mission.link.report(LinkState::Connected);
    mission.step();
    EXPECT_THAT(mission.messages, ElementsAre("battery low"));
    EXPECT_EQ(mission.otherEvents.size(), 2U);
    ASSERT_TRUE(mission.robot);
    EXPECT_EQ(mission.robot->link, LinkState::Connected);
}

TEST(VisitRunner, aClockThatJumpsBackFiresNothing) {
    Mission mission;
    mission.runner.start();
    mission.step();
    mission.runner.advance(-1e9);
    mission.runner.advance(std::nan(""));
    EXPECT_EQ(mission.stateOf(0), VisitState::Sent);
    EXPECT_EQ(mission.link.goals.size(), 1U);
}

TEST(VisitRunner, refusesVisitsOfAnotherPlanAndBadSettings) {
    ScriptedRobotLink link;
    EXPECT_THROW(VisitRunner(link, planOf(2), draftsOf(planOf(3)), {}), Error);
    VisitSettings settings;
    settings.photoTimeout_s = 0.0;
    EXPECT_THROW(VisitRunner(link, planOf(1), draftsOf(planOf(1)), settings), Error);
    settings = {};
    settings.maximumTries = 0;
    EXPECT_THROW(VisitRunner(link, planOf(1), draftsOf(planOf(1)), settings), Error);
}

TEST(VisitRunner, statesHaveWords) {
    EXPECT_EQ(toString(VisitState::Driving), "driving");
    EXPECT_EQ(toString(LinkState::Lost), "link lost");
    EXPECT_EQ(toString(GoalFailure::NotAcknowledged), "not confirmed by the robot");
    EXPECT_EQ(toString(PhotoFailure::Corrupt), "the photo is damaged");
}

}  // namespace
}  // namespace fodscope
