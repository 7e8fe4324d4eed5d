// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/planning/Waypoints.h"
#include "core/robot/RobotLink.h"
#include "core/robot/Visit.h"
#include "core/robot/VisitChecks.h"

namespace fodscope {

enum class RunnerState { Idle, Running, Paused, Finished };

/// What one advance() brought: visits that changed and photos that arrived, oldest first.
struct VisitProgress {
    std::vector<Visit> changedVisits;
    std::vector<Photo> photos;
    std::vector<std::string> messages;
    std::optional<RobotState> robot;
    /// Maps and grids that came meanwhile: the runner alone polls the link while it drives.
    std::vector<RobotEvent> otherEvents;
};

/// Drives a plan through a RobotLink: next waypoint, wait for acceptance, arrival and photo, then the next. The plan is
/// never rewritten; resume goes on at the first visit in Draft, see resumedVisits(). Waypoints without a pose are
/// skipped with their reason.
///
/// Nothing is sent before it is on record: what one advance() decides to send leaves with the next one, so keep what
/// it returned, photos before visits, before calling it again. Cancels alone leave at once.
///
/// A drive that is not confirmed, given up, late, forgotten by the robot or ended elsewhere is sent again after a
/// pause, up to the greatest number of tries, and then the visit has failed and the next begins; photos likewise. A
/// link that is lost is waited for, for a while. When it stays lost, the robot is stopped elsewhere, somebody else
/// gives it a goal, it does not know where it is or its clock is wrong, the visit goes back to Draft and the runner
/// holds, for a person to look. Whatever the robot says about goals and photos of other visits changes nothing.
class VisitRunner {
  public:
    /// @param visits one for each waypoint of the plan, in order; Draft for a new plan. Recorded ones go on by the rule
    ///        of resumedVisits()
    /// @param kept the photos that are kept already
    /// @throws Error when visits and waypoints do not match, or a setting is out of range
    VisitRunner(RobotLink& link, VisitPlan plan, std::vector<Visit> visits, VisitSettings settings,
                std::vector<PhotoMark> kept = {});

    void start();  ///< begin, or go on after a pause or stop
    void pause();  ///< let the visit under way end, then hold
    void skip();   ///< give up the visit under way and go on with the next
    void stop();   ///< cancel every goal at once and hold
    /// Puts a visit that failed, was skipped or is done back to Draft, to be driven again after start(). Nothing
    /// happens to one that is in Draft or under way.
    /// @throws Error for a waypoint that the plan does not have
    void retry(const std::string& waypointId);

    /// Fetches events and moves on. Call it some ten times a second.
    /// @param now_s monotonic
    /// @param utc what photos' times are compared with
    VisitProgress advance(double now_s, UtcTime utc);
    VisitProgress advance(double now_s) { return advance(now_s, UtcTime::now()); }

    RunnerState state() const { return runnerState_; }
    const std::vector<Visit>& visits() const { return visits_; }
    const VisitPlan& plan() const { return plan_; }
    /// Of the photos that came before and those handed over since.
    const std::vector<PhotoMark>& photoMarks() const { return kept_; }

  private:
    /// The visit under way.
    struct Active {
        std::size_t index = 0;
        int tries = 0;
        /// Those of this run: the robot may answer to an earlier one late.
        std::vector<std::string> goalIds;
        std::vector<std::string> photoIds;
        /// Since when the next event is awaited.
        double since_s = 0.0;
        /// Set while it waits for its next try.
        std::optional<double> pausedUntil_s;
        /// When the robot's state named the goal last, or somebody else's goal first.
        std::optional<double> named_s;
        std::optional<double> stranger_s;
        std::optional<Pose2> saysItStands_map;
        UtcTime arrived;
    };

    Visit& activeVisit() { return visits_[active_->index]; }
    const Waypoint& activeWaypoint() const { return plan_.waypoints[active_->index]; }
    bool isOurs(const std::string& goalId) const;
    bool isDriveOver() const;
    bool isLinkDown() const { return linkDownSince_s_.has_value(); }
    void setState(Visit& visit, VisitState state, VisitReason reason = VisitReason::None,
                  const std::string& detail = "");
    void say(const std::string& message) { pending_.messages.push_back(message); }

    void handle(const RobotStateChanged& event);
    void handle(const GoalAccepted& event);
    void handle(const GoalArrived& event);
    void handle(const GoalFailed& event);
    void handle(PhotoReceived event);
    void handle(const PhotoFailed& event);
    void handle(MapReceived event) { pending_.otherEvents.emplace_back(std::move(event)); }
    void handle(GridReceived event) { pending_.otherEvents.emplace_back(std::move(event)); }
    void handle(const LinkMessage& event) { say(event.text); }
    void linkIs(bool up);
    void noteGoal(const RobotState& state);

    void sendWhatIsDue();
    void checkLink();
    void checkActive();
    void checkDrive(double waited_s);
    void checkArrival(double waited_s);
    void arrive(const std::optional<Pose2>& saysItStands_map);
    std::optional<Pose2> standsAt_map() const;
    void sendCancelAgain();
    void begin();
    bool mayBegin(Visit& next);
    bool takeUpAgain(const Visit& next);
    void sendGoal();
    void requestPhoto();
    void driveFailed(VisitReason reason, const std::string& detail);
    void photoFailed(VisitReason reason, const std::string& detail);
    void holdFor(VisitReason reason, const std::string& detail);
    void endVisit(VisitState state, VisitReason reason = VisitReason::None, const std::string& detail = "");
    void cancelOnRobot();

    RobotLink& link_;
    VisitPlan plan_;
    std::vector<Visit> visits_;
    VisitSettings settings_;
    std::vector<PhotoMark> kept_;
    RunnerState runnerState_ = RunnerState::Idle;
    std::optional<Active> active_;
    /// What the next advance() returns.
    VisitProgress pending_;
    /// What leaves with the next advance().
    std::optional<RobotGoal> goalToSend_;
    std::optional<std::string> photoToAsk_;
    /// Empty until the link has told.
    std::optional<RobotState> robot_;
    double robotTold_s_ = 0.0;
    std::optional<double> linkDownSince_s_;
    double now_s_ = 0.0;
    UtcTime utc_;
    std::optional<double> runningSince_s_;
    /// No goal is sent before this time: a cancel may still be on its way and would take the new goal with it.
    double quietUntil_s_ = 0.0;
    /// stop() and skip() know no time: the next advance() counts from its own.
    bool cancelSent_ = false;
    /// The last goal that the robot was told to give up; cancelled again while the robot still names it.
    std::string stoppedGoalId_;
    bool stoppedGoalIsAlive_ = false;
    double stopSent_s_ = 0.0;
    int cancelsSent_ = 0;
};

}  // namespace fodscope
