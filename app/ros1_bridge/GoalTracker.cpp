// SPDX-License-Identifier: MIT
#include "app/ros1_bridge/GoalTracker.h"

#include <algorithm>
#include <utility>

namespace fodscope::bridge {
namespace {

/// The server names every goal some times a second, ended ones for seconds longer.
constexpr double kForgottenAfter_s = 1.0;
constexpr double kSilentAfter_s = 5.0;
constexpr double kCancelAgainAfter_s = 1.0;

bool isUnderWay(ActionStatus status) {
    return status == ActionStatus::Pending || status == ActionStatus::Active || status == ActionStatus::Preempting ||
           status == ActionStatus::Recalling;
}

}  // namespace

void GoalTracker::sent(const std::string& goalId, double now_s) {
    goalId_ = goalId;
    isAccepted_ = false;
    missingSince_s_.reset();
    heard_s_ = now_s;
    cancelled_s_.reset();
}

void GoalTracker::cancelled(double now_s) {
    cancelled_s_ = now_s;
}

void GoalTracker::onStatus(const std::vector<GoalStatusMessage>& goals, double now_s) {
    onServer_ = goals;
    heard_s_ = now_s;
    for (const GoalStatusMessage& goal : goals)
        latestStamp_ns_ = std::max(latestStamp_ns_, goal.stamp_ns);
    if (cancelled_s_ && !anyGoalUnderWay() && now_s - *cancelled_s_ >= kCancelAgainAfter_s) cancelled_s_.reset();
    if (!goalId_) return;
    const auto own = std::find_if(goals.begin(), goals.end(),
                                  [this](const GoalStatusMessage& goal) { return goal.id == idOnRobot(*goalId_); });
    if (own == goals.end()) {
        if (isAccepted_ && !missingSince_s_) missingSince_s_ = now_s;
        return;
    }
    missingSince_s_.reset();
    if (!std::exchange(isAccepted_, true)) tell_(GoalAccepted{*goalId_});
    if (!isUnderWay(own->status)) end(own->status, own->text);
}

void GoalTracker::onResult(const GoalStatusMessage& result) {
    if (!goalId_ || result.id != idOnRobot(*goalId_)) return;
    if (!std::exchange(isAccepted_, true)) tell_(GoalAccepted{*goalId_});
    end(result.status, result.text);
}

void GoalTracker::onTick(double now_s) {
    if (!goalId_ || !isAccepted_) return;
    if (missingSince_s_ && now_s - *missingSince_s_ >= kForgottenAfter_s) {
        fail(GoalProblem::Aborted, "the navigation was restarted and does not know the goal any more");
    } else if (now_s - heard_s_ >= kSilentAfter_s) {
        fail(GoalProblem::LinkLost, "the navigation has said nothing for 5 s; what the robot does is not known");
    }
}

std::optional<std::string> GoalTracker::goalUnderWay() const {
    for (const GoalStatusMessage& goal : onServer_) {
        if (isUnderWay(goal.status) && goal.id.compare(0, prefix_.size(), prefix_) == 0)
            return goal.id.substr(prefix_.size());
    }
    return std::nullopt;
}

bool GoalTracker::anyGoalUnderWay() const {
    return std::any_of(onServer_.begin(), onServer_.end(),
                       [](const GoalStatusMessage& goal) { return isUnderWay(goal.status); });
}

bool GoalTracker::isCancelDue(double now_s) const {
    return cancelled_s_ && now_s - *cancelled_s_ >= kCancelAgainAfter_s && anyGoalUnderWay();
}

void GoalTracker::end(ActionStatus status, const std::string& text) {
    switch (status) {
        case ActionStatus::Succeeded:
            lastArrived_ = *goalId_;
            tell_(GoalArrived{*std::exchange(goalId_, std::nullopt), std::nullopt});
            return;
        case ActionStatus::Rejected:
            return fail(GoalProblem::Rejected, text);
        case ActionStatus::Aborted:
            return fail(GoalProblem::Aborted, text);
        case ActionStatus::Preempted:
        case ActionStatus::Recalled:
            if (cancelled_s_) return fail(GoalProblem::StopRequested, "");
            return fail(GoalProblem::Preempted,
                        text.empty() ? "somebody else cancelled it or sent another goal" : text);
        default:
            return fail(GoalProblem::LinkLost, "the navigation lost track of it; what the robot does is not known");
    }
}

void GoalTracker::fail(GoalProblem problem, const std::string& message) {
    tell_(GoalFailed{*std::exchange(goalId_, std::nullopt), problem, message});
}

}  // namespace fodscope::bridge
