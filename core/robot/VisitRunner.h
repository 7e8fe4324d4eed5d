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
};

/// Drives a plan through a RobotLink: next waypoint, wait for acceptance, arrival and photo, then the next. The plan is
/// never rewritten; resume goes on at the first visit not done. Waypoints without a pose are skipped with their reason.
class VisitRunner {
  public:
    /// @param visits one for each waypoint of the plan, in order; Draft for a new plan
    VisitRunner(RobotLink& link, VisitPlan plan, std::vector<Visit> visits, VisitSettings settings);

    void start();  ///< begin, or go on after a pause or stop
    void pause();  ///< let the visit under way end, then hold
    void skip();   ///< give up the visit under way and go on with the next
    void stop();   ///< cancel every goal at once and hold
    /// Puts a visit that failed, was skipped or is done back to Draft, to be driven again.
    void retry(const std::string& waypointId);

    /// Fetches events and moves on. Call it some ten times a second.
    VisitProgress advance(double now_s);

    RunnerState state() const { return runnerState_; }
    const std::vector<Visit>& visits() const { return visits_; }
    const VisitPlan& plan() const { return plan_; }

  private:
    RobotLink& link_;
    VisitPlan plan_;
    std::vector<Visit> visits_;
    VisitSettings settings_;
    RunnerState runnerState_ = RunnerState::Idle;
};

}  // namespace fodscope
