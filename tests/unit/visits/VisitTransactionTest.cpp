// SPDX-License-Identifier: MIT
// Every way in which the robot can misbehave, through runner, inspection and session file to its end.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/visits/VisitMission.h"

namespace fodscope {
namespace {

using test::Misbehaviour;
using enum Misbehaviour;

/// What becomes of the visit at which the robot misbehaves.
struct Outcome {
    Misbehaviour misbehaviour;
    /// How often the operator has to resume.
    int holds = 0;
    VisitState state = VisitState::Done;
    VisitReason reason = VisitReason::None;
    /// Goals sent, and photos asked for with the latest one.
    int tries = 1;
    int photoTries = 1;
    int cancels = 0;
    std::string steps;
};

const std::string kSmooth = "sent, accepted, driving, arrived, photo, done";
const std::string kToPhoto = "sent, accepted, driving, arrived, photo";

/// Steps in which a try of the drive ended so, and went into another try.
std::string triedAgain(const std::string& tryWent, const std::string& reason) {
    return tryWent + ", draft (" + reason + "), ";
}

/// Steps of two photos, both bad in the same way.
std::string twoBadPhotos(const std::string& reason) {
    return kToPhoto + ", photo (" + reason + "), photo, failed (" + reason + ")";
}

const std::vector<Outcome>& outcomes() {
    using enum VisitState;
    using Why = VisitReason;
    static const std::string kHalf = "sent, accepted, driving";
    static const std::vector<Outcome> kAll{
        {None, 0, Done, Why::None, 1, 1, 0, kSmooth},
        // The goal.
        {NoAcknowledgement, 0, Failed, Why::NotAcknowledged, 2, 0, 1,
         triedAgain("sent", "not acknowledged") + "sent, failed (not acknowledged)"},
        {FirstGoalLost, 0, Done, Why::None, 2, 1, 0, triedAgain("sent", "not acknowledged") + kSmooth},
        {WrongId, 0, Failed, Why::NotAcknowledged, 2, 0, 1,
         triedAgain("sent", "not acknowledged") + "sent, failed (not acknowledged)"},
        {LateAcknowledgement, 0, Done, Why::None, 1, 1, 0,
         triedAgain("sent", "not acknowledged") + "accepted, driving, arrived, photo, done"},
        {DuplicateAnswers, 0, Done, Why::None, 1, 1, 0, kSmooth},
        {AcknowledgesAfterArrival, 0, Done, Why::None, 1, 1, 0, "sent, draft (not acknowledged), arrived, photo, done"},
        {Rejects, 0, Failed, Why::Rejected, 2, 0, 0, triedAgain("sent", "rejected") + "sent, failed (rejected)"},
        {NeverSetsOut, 0, Failed, Why::NotDeparted, 2, 0, 1,
         triedAgain("sent, accepted", "not departed") + "sent, accepted, failed (not departed)"},
        {ClockOff, 1, Done, Why::None, 1, 1, 0, "draft (clock off), " + kSmooth},
        // The drive.
        {AbortsOnce, 0, Done, Why::None, 2, 1, 0, triedAgain(kHalf, "aborted") + kSmooth},
        {AbortsAlways, 0, Failed, Why::Aborted, 2, 0, 0, triedAgain(kHalf, "aborted") + kHalf + ", failed (aborted)"},
        {Preempted, 1, Done, Why::None, 2, 1, 0, kHalf + ", draft (preempted), " + kSmooth},
        {TakenOverSilently, 1, Done, Why::None, 2, 1, 0, kHalf + ", draft (preempted), " + kSmooth},
        {StoppedAtRobot, 1, Done, Why::None, 2, 1, 0, kHalf + ", draft (stopped at robot), " + kSmooth},
        {NeverArrives, 0, Failed, Why::NotArrived, 2, 0, 1,
         triedAgain(kHalf, "not arrived") + kHalf + ", failed (not arrived)"},
        {DisobeysCancel, 1, Failed, Why::NotArrived, 2, 0, 4,
         triedAgain(kHalf, "not arrived") + kHalf + ", failed (not arrived)"},
        {ForgetsTheGoal, 0, Done, Why::None, 2, 1, 0, triedAgain(kHalf, "goal forgotten") + kSmooth},
        {Restarts, 0, Done, Why::None, 2, 1, 0, triedAgain(kHalf, "goal forgotten") + kSmooth},
        {LinkDropsAndReturns, 0, Done, Why::None, 1, 1, 0, kSmooth},
        {LinkDropsForLong, 1, Done, Why::None, 2, 1, 0,
         kHalf + ", draft (link lost), sent, accepted, arrived, photo, done"},
        {ArrivalLost, 0, Done, Why::None, 1, 1, 0, kSmooth},
        {AnswersGarbage, 0, Done, Why::None, 2, 1, 0, triedAgain(kHalf, "aborted") + kSmooth},
        // The arrival.
        {ArrivesElsewhereOnce, 0, Done, Why::None, 2, 1, 0,
         triedAgain(kHalf + ", arrived", "arrived elsewhere") + kSmooth},
        {ArrivesElsewhere, 0, Failed, Why::ArrivedElsewhere, 2, 0, 0,
         triedAgain(kHalf + ", arrived", "arrived elsewhere") + kHalf + ", arrived, failed (arrived elsewhere)"},
        {LosesItself, 1, Done, Why::None, 2, 1, 0,
         kHalf + ", arrived, draft (not localised), sent, accepted, arrived, photo, done"},
        {PoseFrozen, 1, Done, Why::None, 2, 1, 0,
         kHalf + ", arrived, draft (not localised), sent, accepted, arrived, photo, done"},
        // The photo.
        {LinkDropsBeforePhoto, 0, Done, Why::None, 1, 2, 0, kToPhoto + ", photo (photo late), photo, done"},
        {PhotoMissing, 0, Failed, Why::PhotoMissing, 1, 2, 0, twoBadPhotos("photo missing")},
        {PhotoNever, 0, Failed, Why::PhotoLate, 1, 2, 0, twoBadPhotos("photo late")},
        {PhotoLate, 0, Done, Why::None, 1, 2, 0, kToPhoto + ", photo (photo late), photo, done"},
        {PhotoTruncated, 0, Failed, Why::PhotoCorrupt, 1, 2, 0, twoBadPhotos("photo corrupt")},
        {PhotoTruncatedOnce, 0, Done, Why::None, 1, 2, 0, kToPhoto + ", photo (photo corrupt), photo, done"},
        {PhotoBlack, 0, Failed, Why::PhotoBlank, 1, 2, 0, twoBadPhotos("photo blank")},
        {PhotoFrozen, 0, Failed, Why::PhotoRepeated, 1, 2, 0, twoBadPhotos("photo repeated")},
        {PhotoOfAnotherRequest, 0, Failed, Why::PhotoLate, 1, 2, 0, twoBadPhotos("photo late")},
        {PhotoOfAnotherWaypoint, 0, Failed, Why::PhotoOfAnotherPlace, 1, 2, 0, twoBadPhotos("photo of another place")},
        {PhotoFromElsewhere, 0, Failed, Why::PhotoOfAnotherPlace, 1, 2, 0, twoBadPhotos("photo of another place")},
        {PhotoOfYesterday, 0, Failed, Why::PhotoOfAnotherTime, 1, 2, 0, twoBadPhotos("photo of another time")},
        {TwoPhotos, 0, Done, Why::None, 1, 1, 0, kSmooth},
    };
    return kAll;
}

std::string nameOf(Misbehaviour misbehaviour) {
    return std::ranges::find(test::misbehaviours(), misbehaviour, [](const auto& each) { return each.first; })->second;
}

class VisitTransaction : public testing::TestWithParam<Outcome> {};

TEST_P(VisitTransaction, EndsAsItShouldAndIsOnRecordStepByStep) {
    const Outcome& expected = GetParam();
    const bool isSecond = expected.misbehaviour == PhotoFrozen;
    const std::string faulty = isSecond ? "W-02" : "W-01";
    const std::string other = isSecond ? "W-01" : "W-02";
    test::VisitMission mission(expected.misbehaviour);
    const VisitPlan plan = *mission.state().plan;
    int holds = -1;
    do {
        ++holds;
        mission.start();
        mission.run();
        if (mission.runner().state() != RunnerState::Paused) continue;
        mission.pass(30.0);
        // A robot that obeys no stop is stopped by hand.
        if (expected.misbehaviour == DisobeysCancel) mission.robot.restart();
    } while (mission.runner().state() == RunnerState::Paused && holds < 5);

    ASSERT_EQ(mission.runner().state(), RunnerState::Finished);
    EXPECT_EQ(holds, expected.holds);
    const Visit visit = mission.visit(faulty);
    EXPECT_EQ(visit.state, expected.state) << reasonText(visit);
    EXPECT_EQ(visit.reason, expected.reason) << reasonText(visit);
    EXPECT_EQ(visit.tries, expected.tries);
    EXPECT_EQ(visit.photoTries, expected.photoTries);
    EXPECT_EQ(mission.robot.cancels, expected.cancels);
    EXPECT_EQ(mission.visit(other).state, VisitState::Done) << "the plan goes on";
    EXPECT_EQ(mission.stepsOf(faulty), expected.steps);
    for (std::size_t i = 0; i < plan.waypoints.size(); ++i)
        EXPECT_EQ(mission.state().plan->waypoints[i].id, plan.waypoints[i].id) << "the plan is never rewritten";
    const std::size_t photos = expected.state == VisitState::Done ? 2 : 1;
    ASSERT_EQ(mission.state().photos.size(), photos) << "a photo for each visit that is done, and no other";
    for (const Photo& photo : mission.state().photos)
        EXPECT_EQ(mission.visit(photo.waypointId).state, VisitState::Done);
}

INSTANTIATE_TEST_SUITE_P(Robot, VisitTransaction, testing::ValuesIn(outcomes()),
                         [](const auto& info) { return nameOf(info.param.misbehaviour); });

TEST(VisitTransaction, EveryMisbehaviourIsInTheTable) {
    for (const auto& [misbehaviour, name] : test::misbehaviours())
        EXPECT_EQ(std::ranges::count(outcomes(), misbehaviour, &Outcome::misbehaviour), 1) << name;
}

}  // namespace
}  // namespace fodscope
