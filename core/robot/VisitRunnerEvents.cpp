// SPDX-License-Identifier: MIT
// What the robot says, and what it means for the visit under way.
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/robot/VisitRunner.h"

namespace fodscope {
namespace {

VisitReason reasonOf(GoalFailure failure) {
    switch (failure) {
        case GoalFailure::Rejected:
            return VisitReason::Rejected;
        case GoalFailure::Preempted:
            return VisitReason::Preempted;
        case GoalFailure::NotAcknowledged:
            return VisitReason::NotAcknowledged;
        case GoalFailure::TimedOut:
            return VisitReason::NotArrived;
        case GoalFailure::LinkLost:
            return VisitReason::LinkLost;
        case GoalFailure::StopRequested:
            return VisitReason::StoppedAtRobot;
        case GoalFailure::Aborted:
            break;
    }
    return VisitReason::Aborted;
}

VisitReason reasonOf(PhotoFailure failure) {
    switch (failure) {
        case PhotoFailure::Corrupt:
            return VisitReason::PhotoCorrupt;
        case PhotoFailure::TimedOut:
            return VisitReason::PhotoLate;
        case PhotoFailure::LinkLost:
            return VisitReason::LinkLost;
        case PhotoFailure::Missing:
            break;
    }
    return VisitReason::PhotoMissing;
}

}  // namespace

bool VisitRunner::isOurs(const std::string& goalId) const {
    return active_ && std::ranges::find(active_->goalIds, goalId) != active_->goalIds.end();
}

bool VisitRunner::isDriveOver() const {
    const VisitState state = visits_[active_->index].state;
    return state == VisitState::Arrived || state == VisitState::Photo;
}

void VisitRunner::linkIs(bool up) {
    if (!up) {
        if (!linkDownSince_s_) linkDownSince_s_ = now_s_;
        return;
    }
    if (!linkDownSince_s_) return;
    // No time-out counts what could not be heard.
    const double outage_s = now_s_ - *std::exchange(linkDownSince_s_, std::nullopt);
    if (!active_) return;
    active_->since_s += outage_s;
    if (active_->named_s) *active_->named_s += outage_s;
    if (active_->pausedUntil_s) *active_->pausedUntil_s += outage_s;
    active_->stranger_s.reset();
}

void VisitRunner::handle(const RobotStateChanged& event) {
    pending_.robot = event.state;
    linkIs(event.state.link == LinkState::Connected);
    if (event.state.link != LinkState::Connected) return;
    robot_ = event.state;
    if (robot_->clockOffset_s && !std::isfinite(*robot_->clockOffset_s)) robot_->clockOffset_s.reset();
    robotTold_s_ = now_s_;
    noteGoal(event.state);
}

void VisitRunner::noteGoal(const RobotState& state) {
    const std::string goalId = state.goalId.value_or("");
    stoppedGoalIsAlive_ = !goalId.empty() && goalId == stoppedGoalId_ && !isOurs(goalId);
    if (!active_) return;
    const VisitState visitState = activeVisit().state;
    const bool isDriving = visitState == VisitState::Accepted || visitState == VisitState::Driving;
    const bool isStranger = isDriving && !goalId.empty() && !isOurs(goalId);
    if (!isStranger) active_->stranger_s.reset();
    if (isStranger && !active_->stranger_s) active_->stranger_s = now_s_;
    if (!isOurs(goalId)) return;
    active_->named_s = now_s_;
    handle(GoalAccepted{goalId});
    if (state.moving && activeVisit().state == VisitState::Accepted) setState(activeVisit(), VisitState::Driving);
}

void VisitRunner::handle(const GoalAccepted& event) {
    if (!isOurs(event.goalId)) return;
    const VisitState state = activeVisit().state;
    if (state != VisitState::Sent && state != VisitState::Draft) return;
    if (event.goalId != activeVisit().goalId || state == VisitState::Draft)
        say(activeVisit().waypointId + ": the robot confirms " + event.goalId + " after all");
    active_->pausedUntil_s.reset();
    goalToSend_.reset();
    active_->since_s = now_s_;
    setState(activeVisit(), VisitState::Accepted);
}

void VisitRunner::handle(const GoalArrived& event) {
    if (!isOurs(event.goalId) || isDriveOver()) return;
    arrive(isFinite(event.pose_map) ? std::optional(event.pose_map) : std::nullopt);
}

void VisitRunner::arrive(const std::optional<Pose2>& saysItStands_map) {
    active_->pausedUntil_s.reset();
    goalToSend_.reset();
    active_->saysItStands_map = saysItStands_map;
    active_->since_s = now_s_;
    active_->arrived = utc_;
    setState(activeVisit(), VisitState::Arrived);
}

void VisitRunner::handle(const GoalFailed& event) {
    // After the arrival the drive is over, whatever is said about it; an earlier try may end as it likes.
    if (!isOurs(event.goalId) || isDriveOver() || event.goalId != activeVisit().goalId) return;
    if (active_->pausedUntil_s) return;
    const VisitReason reason = reasonOf(event.failure);
    switch (reason) {
        case VisitReason::LinkLost:
            // The goal's fate is not known: the robot tells when it is heard again.
            linkIs(false);
            break;
        case VisitReason::Preempted:
        case VisitReason::StoppedAtRobot:
            holdFor(reason, event.message);
            break;
        default:
            driveFailed(reason, event.message);
    }
}

void VisitRunner::handle(PhotoReceived event) {
    const bool isAwaited = active_ && activeVisit().state == VisitState::Photo &&
                           std::ranges::find(active_->photoIds, event.requestId) != active_->photoIds.end();
    if (!isAwaited) {
        say("a photo that nobody waits for (" + event.requestId + ") was left out");
        return;
    }
    const Waypoint& waypoint = activeWaypoint();
    PhotoExpectation expected;
    expected.waypointId = waypoint.id;
    expected.pose_map = *waypoint.pose_map;
    expected.arrived = active_->arrived;
    expected.now = utc_;
    if (robot_) expected.clockOffset_s = robot_->clockOffset_s.value_or(0.0);
    expected.kept = &kept_;
    if (const auto problem = photoProblem(event.photo, expected, settings_)) {
        const bool isLatest = event.requestId == active_->photoIds.back() && !active_->pausedUntil_s && !photoToAsk_;
        if (isLatest) photoFailed(problem->reason, problem->detail);
        return;
    }
    event.photo.waypointId = waypoint.id;
    event.photo.requestId = event.requestId;
    event.photo.candidateIds = waypoint.candidateIds;
    kept_.push_back({event.requestId, event.photo.sha256});
    pending_.photos.push_back(std::move(event.photo));
    endVisit(VisitState::Done);
}

void VisitRunner::handle(const PhotoFailed& event) {
    const bool isAwaited = active_ && activeVisit().state == VisitState::Photo && !active_->pausedUntil_s &&
                           !photoToAsk_ && !active_->photoIds.empty() && active_->photoIds.back() == event.requestId;
    if (!isAwaited) return;
    const VisitReason reason = reasonOf(event.failure);
    if (reason == VisitReason::LinkLost) {
        linkIs(false);
    } else {
        photoFailed(reason, event.message);
    }
}

}  // namespace fodscope
