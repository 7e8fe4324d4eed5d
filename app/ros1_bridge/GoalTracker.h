// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/ros1_bridge/RosMessages.h"
#include "core/bridge/BridgeProtocol.h"

namespace fodscope::bridge {

/// What became of a goal, from what the action server says. A goal counts as accepted when its id is in the server's
/// status, and as ended by the status or the result, whichever is heard first: either may be lost.
class GoalTracker {
  public:
    using Tell = std::function<void(Event)>;

    /// @param prefix put before the ids on the robot
    GoalTracker(std::string prefix, Tell tell) : prefix_(std::move(prefix)), tell_(std::move(tell)) {}

    /// A goal went out; one before it is no longer followed.
    void sent(const std::string& goalId, double now_s);
    /// Every goal was cancelled; repeat it while isCancelDue().
    void cancelled(double now_s);
    void onStatus(const std::vector<GoalStatusMessage>& goals, double now_s);
    void onResult(const GoalStatusMessage& result);
    void onTick(double now_s);

    /// The goal that is followed, accepted or not.
    const std::optional<std::string>& goalId() const { return goalId_; }
    /// A goal of this workstation that the server works on, even one that another bridge process sent.
    std::optional<std::string> goalUnderWay() const;
    bool anyGoalUnderWay() const;
    /// Whether a cancel seems to have been lost.
    bool isCancelDue(double now_s) const;
    /// The latest stamp among the server's goals: a server cancels goals that are stamped earlier.
    std::int64_t latestStamp_ns() const { return latestStamp_ns_; }
    std::string idOnRobot(const std::string& goalId) const { return prefix_ + goalId; }
    /// The goal reached last.
    const std::string& lastArrived() const { return lastArrived_; }

  private:
    void end(ActionStatus status, const std::string& text);
    void fail(GoalProblem problem, const std::string& message);

    std::string prefix_;
    Tell tell_;
    std::optional<std::string> goalId_;
    bool isAccepted_ = false;
    std::optional<double> missingSince_s_;
    double heard_s_ = 0.0;
    std::optional<double> cancelled_s_;
    std::vector<GoalStatusMessage> onServer_;
    std::int64_t latestStamp_ns_ = 0;
    std::string lastArrived_;
};

}  // namespace fodscope::bridge
