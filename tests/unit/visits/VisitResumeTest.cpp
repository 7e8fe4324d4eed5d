// SPDX-License-Identifier: MIT
// The program dies after every act of a mission, and another one goes on from the session file.
#include <gtest/gtest.h>

#include <set>

#include "tests/unit/visits/VisitMission.h"

namespace fodscope {
namespace {

using test::Misbehaviour;

/// How long nobody is there, and whether the robot loses its power meanwhile.
struct Interruption {
    std::string name;
    double away_s = 0.0;
    bool robotRestarts = false;
    Misbehaviour misbehaviour = Misbehaviour::None;
};

class VisitResume : public testing::TestWithParam<Interruption> {};

TEST_P(VisitResume, AfterEveryStepTheSamePlanIsDoneWithOnePhotoForEachWaypoint) {
    const Interruption& interruption = GetParam();
    std::size_t acts = 1;
    for (;; ++acts) {
        SCOPED_TRACE("died after act " + std::to_string(acts));
        test::VisitMission mission(interruption.misbehaviour);
        mission.start();
        if (!mission.dieAfter(acts)) break;
        mission.pass(interruption.away_s);
        if (interruption.robotRestarts) mission.robot.restart();
        mission.reopen();
        EXPECT_EQ(mission.state().plan->waypoints.size(), 2U);
        mission.start();
        mission.run();
        ASSERT_EQ(mission.runner().state(), RunnerState::Finished);
        std::multiset<std::string> photographed;
        std::set<std::string> goals(mission.robot.goalsReceived.begin(), mission.robot.goalsReceived.end());
        for (const Photo& photo : mission.state().photos)
            photographed.insert(photo.waypointId);
        EXPECT_EQ(photographed, (std::multiset<std::string>{"W-01", "W-02"})) << "none lost, none twice";
        EXPECT_EQ(goals.size(), mission.robot.goalsReceived.size()) << "no goal id is used twice";
        for (const Visit& visit : mission.state().visits) {
            EXPECT_EQ(visit.state, VisitState::Done) << reasonText(visit);
            EXPECT_LE(visit.tries, 3);
        }
        mission.stepsOf("W-01");
    }
    // Sent, accepted, driving, arrived, photo, the photo itself, done: of two visits.
    EXPECT_GE(acts, 14U) << "the mission was cut at every act";
}

INSTANTIATE_TEST_SUITE_P(Program, VisitResume,
                         testing::Values(Interruption{"atOnce", 0.0}, Interruption{"shortly", 1.0},
                                         Interruption{"forLong", 60.0}, Interruption{"withTheRobot", 5.0, true},
                                         Interruption{"inTroubleToo", 1.0, false, Misbehaviour::AbortsOnce},
                                         Interruption{"withABadPhoto", 0.0, false, Misbehaviour::PhotoTruncatedOnce}),
                         [](const auto& info) { return info.param.name; });

TEST(VisitResume, ADriveThatTheRobotIsStillOnIsGoneOnWith) {
    test::VisitMission mission(Misbehaviour::None);
    mission.start();
    ASSERT_TRUE(mission.dieAfter(3)) << "driving";
    mission.reopen();
    EXPECT_EQ(mission.visit("W-01").reason, VisitReason::Interrupted);
    mission.start();
    mission.run();
    EXPECT_EQ(mission.visit("W-01").tries, 1);
    EXPECT_EQ(mission.stepsOf("W-01"),
              "sent, accepted, driving, draft (interrupted), accepted, driving, arrived, photo, done");
}

TEST(VisitResume, APhotoThatWasKeptEndsItsVisit) {
    test::VisitMission mission(Misbehaviour::None);
    mission.start();
    ASSERT_TRUE(mission.dieAfter(6)) << "between photo and done";
    mission.reopen();
    EXPECT_EQ(mission.visit("W-01").state, VisitState::Done);
    EXPECT_EQ(mission.stepsOf("W-01"), "sent, accepted, driving, arrived, photo, done");
}

}  // namespace
}  // namespace fodscope
