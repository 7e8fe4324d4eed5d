// SPDX-License-Identifier: MIT
#include "core/robot/VisitRunner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/common/Error.h"
#include "core/robot/PhotoIntegrity.h"

namespace fodscope {
namespace {

constexpr double kCancelSettles_s = 0.5;

void requireInRange(const VisitSettings& settings) {
    const auto isTime = [](double value) { return value > 0.0 && std::isfinite(value); };
    if (!isTime(settings.acknowledgeTimeout_s) || !isTime(settings.driveTimeout_s) ||
        !isTime(settings.photoTimeout_s) || settings.maximumTries < 1) {
        throw Error("visit settings", "a value is out of range", "give times over 0 s and at least 1 try");
    }
}

bool isUnderWay(VisitState state) {
    return state == VisitState::Sent || state == VisitState::Accepted || state == VisitState::Driving ||
           state == VisitState::Arrived;
}

std::string because(const std::string& what, const std::string& message) {
    return message.empty() ? what : what + ": " + message;
}

}  // namespace

VisitRunner::VisitRunner(RobotLink& link, VisitPlan plan, std::vector<Visit> visits, VisitSettings settings)
    : link_(link), plan_(std::move(plan)), visits_(std::move(visits)), settings_(settings) {
    requireInRange(settings_);
    const bool match =
        std::equal(visits_.begin(), visits_.end(), plan_.waypoints.begin(), plan_.waypoints.end(),
                   [](const Visit& visit, const Waypoint& waypoint) { return visit.waypointId == waypoint.id; });
    if (!match) throw Error("visits", "they are not those of the plan", "plan the visits anew");
    for (Visit& visit : visits_) {
        if (isUnderWay(visit.state)) setState(visit, VisitState::Draft, "interrupted");
    }
}

void VisitRunner::setState(Visit& visit, VisitState state, const std::string& reason) {
    visit.state = state;
    visit.reason = reason;
    pending_.changedVisits.push_back(visit);
}

void VisitRunner::start() {
    for (std::size_t i = 0; i < visits_.size(); ++i) {
        const Waypoint& waypoint = plan_.waypoints[i];
        if (visits_[i].state != VisitState::Draft || waypoint.pose_map) continue;
        setState(visits_[i], VisitState::Skipped, toString(waypoint.status));
    }
    runnerState_ = RunnerState::Running;
}

void VisitRunner::pause() {
    if (runnerState_ == RunnerState::Running) runnerState_ = RunnerState::Paused;
}

void VisitRunner::skip() {
    if (!active_) return;
    cancelOnRobot();
    cancelSent_ = true;
    endVisit(VisitState::Skipped, "skipped by the operator");
}

void VisitRunner::stop() {
    cancelOnRobot();
    cancelSent_ = true;
    if (active_) endVisit(VisitState::Draft, "stopped by the operator");
    if (runnerState_ == RunnerState::Running) runnerState_ = RunnerState::Paused;
}

void VisitRunner::retry(const std::string& waypointId) {
    const auto visit =
        std::find_if(visits_.begin(), visits_.end(), [&](const Visit& each) { return each.waypointId == waypointId; });
    if (visit == visits_.end()) throw Error(waypointId, "the plan has no such waypoint", "choose one of its waypoints");
    if (visit->state == VisitState::Draft || isUnderWay(visit->state)) return;
    setState(*visit, VisitState::Draft);
    if (runnerState_ == RunnerState::Finished) runnerState_ = RunnerState::Paused;
}

VisitProgress VisitRunner::advance(double now_s) {
    if (now_s > now_s_) now_s_ = now_s;
    if (std::exchange(cancelSent_, false)) {
        quietUntil_s_ = now_s_ + kCancelSettles_s;
        stopSent_s_ = now_s_;
    }
    for (RobotEvent& event : link_.poll(now_s_)) {
        std::visit([this](auto& each) { handle(std::move(each)); }, event);
    }
    checkTimeouts();
    sendCancelAgain();
    begin();
    return std::exchange(pending_, {});
}

void VisitRunner::handle(const RobotStateChanged& event) {
    pending_.robot = event.state;
    linkState_ = event.state.link;
    if (linkState_ == LinkState::Lost || linkState_ == LinkState::Disconnected) {
        if (active_) holdFor(toString(*linkState_));
        return;
    }
    const std::string goalId = event.state.goalId.value_or("");
    stoppedGoalIsAlive_ = !goalId.empty() && goalId == stoppedGoalId_;
    if (goalId.empty() || !isAwaited(goalId)) return;
    handle(GoalAccepted{goalId});
    if (event.state.moving && activeVisit().state == VisitState::Accepted) setState(activeVisit(), VisitState::Driving);
}

void VisitRunner::handle(const GoalAccepted& event) {
    if (!isAwaited(event.goalId) || activeVisit().state != VisitState::Sent) return;
    active_->since_s = now_s_;
    setState(activeVisit(), VisitState::Accepted);
}

void VisitRunner::handle(const GoalArrived& event) {
    if (!isAwaited(event.goalId) || activeVisit().state == VisitState::Arrived) return;
    setState(activeVisit(), VisitState::Arrived);
    requestPhoto();
}

void VisitRunner::handle(const GoalFailed& event) {
    // After the arrival the drive is over, whatever is said about it.
    if (!isAwaited(event.goalId) || activeVisit().state == VisitState::Arrived) return;
    const std::string reason = because(toString(event.failure), event.message);
    switch (event.failure) {
        case GoalFailure::LinkLost:
        case GoalFailure::Preempted:
        case GoalFailure::StopRequested:
            holdFor(reason);
            break;
        default:
            driveFailed(event.failure, event.message);
    }
}

void VisitRunner::handle(PhotoReceived event) {
    if (!active_ || active_->photoRequestId.empty() || active_->photoRequestId != event.requestId) {
        say("a photo that nobody waits for (" + event.requestId + ") was left out");
        return;
    }
    const PhotoCheck check = checkPhoto(event.photo.bytes);
    if (!check.problem.empty()) {
        photoFailed(PhotoFailure::Corrupt, check.problem);
        return;
    }
    const Waypoint& waypoint = plan_.waypoints[active_->index];
    event.photo.waypointId = waypoint.id;
    event.photo.candidateIds = waypoint.candidateIds;
    event.photo.mediaType = check.mediaType;
    pending_.photos.push_back(std::move(event.photo));
    endVisit(VisitState::Done, "");
}

void VisitRunner::handle(const PhotoFailed& event) {
    if (!active_ || active_->photoRequestId.empty() || active_->photoRequestId != event.requestId) return;
    if (event.failure == PhotoFailure::LinkLost) {
        holdFor(because(toString(event.failure), event.message));
    } else {
        photoFailed(event.failure, event.message);
    }
}

void VisitRunner::checkTimeouts() {
    if (!active_) return;
    const double waited_s = now_s_ - active_->since_s;
    const VisitState state = activeVisit().state;
    if (state == VisitState::Sent && waited_s >= settings_.acknowledgeTimeout_s) {
        driveFailed(GoalFailure::NotAcknowledged, "");
    } else if ((state == VisitState::Accepted || state == VisitState::Driving) &&
               waited_s >= settings_.driveTimeout_s) {
        driveFailed(GoalFailure::TimedOut, "");
    } else if (state == VisitState::Arrived && waited_s >= settings_.photoTimeout_s) {
        photoFailed(PhotoFailure::TimedOut, "");
    }
}

/// Cancels get lost on a bad link: repeat until the robot names the stopped goal no more.
void VisitRunner::sendCancelAgain() {
    if (!stoppedGoalIsAlive_ || linkState_ != LinkState::Connected || active_) return;
    if (now_s_ - stopSent_s_ < settings_.acknowledgeTimeout_s) return;
    say("the robot still works on " + stoppedGoalId_ + "; the stop was sent again");
    link_.cancelAllGoals();
    stopSent_s_ = now_s_;
}

void VisitRunner::begin() {
    if (active_ || runnerState_ == RunnerState::Idle || runnerState_ == RunnerState::Finished) return;
    const auto next = std::find_if(visits_.begin(), visits_.end(),
                                   [](const Visit& visit) { return visit.state == VisitState::Draft; });
    if (next == visits_.end()) {
        runnerState_ = RunnerState::Finished;
        return;
    }
    if (runnerState_ != RunnerState::Running || now_s_ < quietUntil_s_) return;
    // A link that has not said anything yet may be up; one that says it is not would lose the goal.
    if (linkState_.value_or(LinkState::Connected) != LinkState::Connected) return;
    active_ = Active{};
    active_->index = static_cast<std::size_t>(next - visits_.begin());
    sendGoal();
}

void VisitRunner::sendGoal() {
    Visit& visit = activeVisit();
    ++visit.tries;
    ++active_->tries;
    active_->since_s = now_s_;
    visit.goalId = visit.waypointId + "/" + std::to_string(visit.tries);
    setState(visit, VisitState::Sent);
    stoppedGoalIsAlive_ = false;
    link_.sendGoal({visit.goalId, *plan_.waypoints[active_->index].pose_map});
}

void VisitRunner::requestPhoto() {
    ++active_->photoRequests;
    active_->since_s = now_s_;
    active_->photoRequestId = activeVisit().goalId + "/photo-" + std::to_string(active_->photoRequests);
    link_.requestPhoto(active_->photoRequestId);
}

void VisitRunner::driveFailed(GoalFailure failure, const std::string& message) {
    const std::string reason = because(toString(failure), message);
    if (active_->tries < settings_.maximumTries) {
        say(activeVisit().waypointId + " " + reason + "; sent again");
        // No cancel before it: the new goal replaces the old one, and a late cancel would take the new one with it.
        sendGoal();
        return;
    }
    // The robot may still be on its way when only its answer is missing.
    if (failure == GoalFailure::NotAcknowledged || failure == GoalFailure::TimedOut) {
        cancelOnRobot();
        quietUntil_s_ = now_s_ + kCancelSettles_s;
    }
    endVisit(VisitState::Failed, reason);
}

void VisitRunner::photoFailed(PhotoFailure failure, const std::string& message) {
    const std::string reason = because(toString(failure), message);
    if (active_->photoRequests < settings_.maximumTries) {
        say(activeVisit().waypointId + " " + reason + "; asked again");
        requestPhoto();
        return;
    }
    endVisit(VisitState::Failed, reason);
}

void VisitRunner::holdFor(const std::string& reason) {
    say("holding at " + activeVisit().waypointId + ": " + reason);
    endVisit(VisitState::Draft, reason);
    if (runnerState_ == RunnerState::Running) runnerState_ = RunnerState::Paused;
}

/// Ends the visit under way.
void VisitRunner::endVisit(VisitState state, const std::string& reason) {
    Visit& visit = activeVisit();
    active_.reset();
    setState(visit, state, reason);
}

void VisitRunner::cancelOnRobot() {
    if (active_) stoppedGoalId_ = activeVisit().goalId;
    link_.cancelAllGoals();
    stopSent_s_ = now_s_;
}

}  // namespace fodscope
