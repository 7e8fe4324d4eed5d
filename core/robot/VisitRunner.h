// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/planning/Waypoints.h"
#include "core/robot/RobotLink.h"

namespace fodscope {

enum class VisitState { Draft, Sent, Accepted, Driving, Arrived, Done, Failed, Skipped };

/// @return the word shown to people and kept in the record, e.g. "driving"
std::string toString(VisitState state);

/// One drive to a waypoint and its photo.
struct Visit {
    std::string waypointId;
    VisitState state = VisitState::Draft;
    /// Goal of the latest try; empty before the first.
    std::string goalId;
    /// Why it failed or was skipped, in words.
    std::string reason;
    int tries = 0;

    bool operator==(const Visit&) const = default;
};

struct VisitSettings {
    /// A goal that the robot has not confirmed within this time counts as not acknowledged.
    double acknowledgeTimeout_s = 3.0;
    double driveTimeout_s = 120.0;
    double photoTimeout_s = 10.0;
    int maximumTries = 2;

    bool operator==(const VisitSettings&) const = default;
};

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
/// never rewritten; resume goes on at the first visit in Draft. Waypoints without a pose are skipped with their reason.
///
/// A goal that is not confirmed, aborted or late is sent again, up to the greatest number of tries, and then the visit
/// has failed and the next begins; photos likewise. When the link is lost, the robot is stopped elsewhere, or somebody
/// else gives it a goal, the visit goes back to Draft and the runner holds, for a person to look. Whatever the robot
/// says about goals and photos that are not the ones awaited changes nothing.
class VisitRunner {
  public:
    /// @param visits one for each waypoint of the plan, in order; Draft for a new plan. A visit that was under way when
    ///        it was recorded goes back to Draft
    /// @throws Error when visits and waypoints do not match, or a setting is out of range
    VisitRunner(RobotLink& link, VisitPlan plan, std::vector<Visit> visits, VisitSettings settings);

    void start();  ///< begin, or go on after a pause or stop
    void pause();  ///< let the visit under way end, then hold
    void skip();   ///< give up the visit under way and go on with the next
    void stop();   ///< cancel every goal at once and hold
    /// Puts a visit that failed, was skipped or is done back to Draft, to be driven again after start(). Nothing
    /// happens to one that is in Draft or under way.
    /// @throws Error for a waypoint that the plan does not have
    void retry(const std::string& waypointId);

    /// Fetches events and moves on. Call it some ten times a second.
    VisitProgress advance(double now_s);

    RunnerState state() const { return runnerState_; }
    const std::vector<Visit>& visits() const { return visits_; }
    const VisitPlan& plan() const { return plan_; }

  private:
    /// The visit under way.
    struct Active {
        std::size_t index = 0;
        int tries = 0;
        int photoRequests = 0;
        /// Empty until the robot has arrived.
        std::string photoRequestId;
        /// Since when the next event is awaited.
        double since_s = 0.0;
    };

    Visit& activeVisit() { return visits_[active_->index]; }
    bool isAwaited(const std::string& goalId) const { return active_ && visits_[active_->index].goalId == goalId; }
    void setState(Visit& visit, VisitState state, const std::string& reason = "");
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

    void checkTimeouts();
    void sendCancelAgain();
    void begin();
    void sendGoal();
    void requestPhoto();
    void driveFailed(GoalFailure failure, const std::string& message);
    void photoFailed(PhotoFailure failure, const std::string& message);
    void holdFor(const std::string& reason);
    void endVisit(VisitState state, const std::string& reason);
    void cancelOnRobot();

    RobotLink& link_;
    VisitPlan plan_;
    std::vector<Visit> visits_;
    VisitSettings settings_;
    RunnerState runnerState_ = RunnerState::Idle;
    std::optional<Active> active_;
    /// What the next advance() returns.
    VisitProgress pending_;
    /// Empty until the link has told.
    std::optional<LinkState> linkState_;
    double now_s_ = 0.0;
    /// No goal is sent before this time: a cancel may still be on its way and would take the new goal with it.
    double quietUntil_s_ = 0.0;
    /// stop() and skip() know no time: the next advance() counts from its own.
    bool cancelSent_ = false;
    /// The last goal that the robot was told to give up; cancelled again while the robot still names it.
    std::string stoppedGoalId_;
    bool stoppedGoalIsAlive_ = false;
    double stopSent_s_ = 0.0;
};

}  // namespace fodscope
