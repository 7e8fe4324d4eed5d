// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/robot/RobotLink.h"

namespace fodscope::test {

/// What a robot does wrong on its way to the first waypoint, "W-01". On the way to others it behaves.
enum class Misbehaviour {
    None,
    // The goal.
    NoAcknowledgement,
    FirstGoalLost,
    WrongId,
    LateAcknowledgement,
    DuplicateAnswers,
    AcknowledgesAfterArrival,
    Rejects,
    NeverSetsOut,
    ClockOff,
    // The drive.
    AbortsOnce,
    AbortsAlways,
    Preempted,
    TakenOverSilently,
    StoppedAtRobot,
    NeverArrives,
    DisobeysCancel,
    ForgetsTheGoal,
    Restarts,
    LinkDropsAndReturns,
    LinkDropsForLong,
    ArrivalLost,
    AnswersGarbage,
    // The arrival.
    ArrivesElsewhereOnce,
    ArrivesElsewhere,
    LosesItself,
    PoseFrozen,
    // The photo.
    LinkDropsBeforePhoto,
    PhotoMissing,
    PhotoNever,
    PhotoLate,
    PhotoTruncated,
    PhotoTruncatedOnce,
    PhotoBlack,
    PhotoFrozen,
    PhotoOfAnotherRequest,
    PhotoOfAnotherWaypoint,
    PhotoFromElsewhere,
    PhotoOfYesterday,
    TwoPhotos
};

/// A robot in the plane, driven by the clock of poll(): it confirms a goal after 0.2 s, drives straight at 1 m/s, and
/// sends a photo after 0.5 s, no two alike. All but what its misbehaviour says. What is said while the link is down is
/// lost, both ways.
class MisbehavingRobot : public RobotLink {
  public:
    /// @param epoch the wall clock at 0 s
    explicit MisbehavingRobot(Misbehaviour misbehaviour, UtcTime epoch = {1'795'000'000'000})
        : misbehaviour_(misbehaviour), epoch_(epoch) {}

    std::string name() const override { return "misbehaving robot"; }
    void connect() override {}
    void disconnect() override {}
    void requestMap() override {}
    void requestGrid() override {}
    void sendGoal(const RobotGoal& goal) override;
    void cancelAllGoals() override;
    void requestPhoto(const std::string& requestId) override;
    std::vector<RobotEvent> poll(double now_s) override;

    UtcTime utcAt(double now_s) const;
    /// Forgets what it does, as a robot whose power was cut.
    void restart();

    std::vector<std::string> goalsReceived;
    std::vector<std::string> photosAsked;
    int cancels = 0;

  private:
    struct Drive {
        RobotGoal goal;
        double sent_s = 0.0;
        bool isConfirmed = false;
        double length_m = 0.0;
        double driven_m = 0.0;
        bool hasHadItsFault = false;
    };
    struct Exposure {
        std::string requestId;
        double due_s = 0.0;
    };

    bool does(Misbehaviour misbehaviour) const { return misbehaviour == misbehaviour_; }
    bool isFaultyDrive() const { return drive_ && drive_->goal.id.starts_with("W-01"); }
    bool isFirstDrive() const { return drive_ && drive_->goal.id == "W-01/1"; }
    void say(RobotEvent event);
    void dropLink(double duration_s);
    void confirm();
    void drive(double duration_s);
    void misbehaveHalfWay();
    void arrive();
    void develop();
    void answer(const Exposure& exposure);
    Photo photoFor(const std::string& requestId);
    RobotState state() const;

    Misbehaviour misbehaviour_;
    UtcTime epoch_;
    double now_s_ = 0.0;
    Pose2 pose_map_;
    std::optional<Drive> drive_;
    std::optional<std::string> strangersGoal_;
    bool isLost_ = false;
    std::optional<double> poseFrozen_s_;
    double linkBack_s_ = 0.0;
    bool hasDroppedLink_ = false;
    std::vector<Exposure> exposures_;
    int photosTaken_ = 0;
    std::vector<RobotEvent> events_;
};

/// @return every misbehaviour with its name
const std::vector<std::pair<Misbehaviour, std::string>>& misbehaviours();

}  // namespace fodscope::test
