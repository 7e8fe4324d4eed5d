// SPDX-License-Identifier: MIT
#include "core/robot/VisitRunner.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/common/Error.h"

namespace fodscope {
namespace {

constexpr double kCancelSettles_s = 0.5;

std::string because(const std::string& what, const std::string& detail) {
    return detail.empty() ? what : what + ": " + detail;
}

std::string seconds(double value_s) {
    char text[48];
    std::snprintf(text, sizeof text, "%.1f s", value_s);
    return text;
}

}  // namespace

VisitRunner::VisitRunner(RobotLink& link, VisitPlan plan, std::vector<Visit> visits, VisitSettings settings,
                         std::vector<PhotoMark> kept)
    : link_(link), plan_(std::move(plan)), visits_(visits), settings_(settings), kept_(std::move(kept)) {
    requireInRange(settings_);
    const bool match =
        std::equal(visits_.begin(), visits_.end(), plan_.waypoints.begin(), plan_.waypoints.end(),
                   [](const Visit& visit, const Waypoint& waypoint) { return visit.waypointId == waypoint.id; });
    if (!match) throw Error("visits", "they are not those of the plan", "plan the visits anew");
    visits_ = resumedVisits(std::move(visits_), kept_);
    for (std::size_t i = 0; i < visits_.size(); ++i) {
        if (visits_[i] != visits[i]) pending_.changedVisits.push_back(visits_[i]);
    }
}

void VisitRunner::setState(Visit& visit, VisitState state, VisitReason reason, const std::string& detail) {
    visit.state = state;
    visit.reason = reason;
    visit.detail = detail;
    pending_.changedVisits.push_back(visit);
}

void VisitRunner::start() {
    for (std::size_t i = 0; i < visits_.size(); ++i) {
        const Waypoint& waypoint = plan_.waypoints[i];
        if (visits_[i].state != VisitState::Draft || waypoint.pose_map) continue;
        setState(visits_[i], VisitState::Skipped, VisitReason::NoPose, toString(waypoint.status));
    }
    runnerState_ = RunnerState::Running;
    runningSince_s_.reset();
}

void VisitRunner::pause() {
    if (runnerState_ == RunnerState::Running) runnerState_ = RunnerState::Paused;
}

void VisitRunner::skip() {
    if (!active_) return;
    cancelOnRobot();
    cancelSent_ = true;
    endVisit(VisitState::Skipped, VisitReason::SkippedByOperator);
}

void VisitRunner::stop() {
    cancelOnRobot();
    cancelSent_ = true;
    if (active_) endVisit(VisitState::Draft, VisitReason::StoppedByOperator);
    if (runnerState_ == RunnerState::Running) runnerState_ = RunnerState::Paused;
}

void VisitRunner::retry(const std::string& waypointId) {
    const auto visit =
        std::find_if(visits_.begin(), visits_.end(), [&](const Visit& each) { return each.waypointId == waypointId; });
    if (visit == visits_.end()) throw Error(waypointId, "the plan has no such waypoint", "choose one of its waypoints");
    if (!isOver(visit->state)) return;
    setState(*visit, VisitState::Draft);
    if (runnerState_ == RunnerState::Finished) runnerState_ = RunnerState::Paused;
}

VisitProgress VisitRunner::advance(double now_s, UtcTime utc) {
    if (now_s > now_s_) now_s_ = now_s;
    utc_ = utc;
    if (!runningSince_s_) runningSince_s_ = now_s_;
    if (std::exchange(cancelSent_, false)) {
        quietUntil_s_ = now_s_ + kCancelSettles_s;
        stopSent_s_ = now_s_;
    }
    sendWhatIsDue();
    for (RobotEvent& event : link_.poll(now_s_)) {
        std::visit([this](auto& each) { handle(std::move(each)); }, event);
    }
    checkLink();
    if (active_ && !isLinkDown()) checkActive();
    sendCancelAgain();
    begin();
    return std::exchange(pending_, {});
}

/// The step before has told of it, and is on record.
void VisitRunner::sendWhatIsDue() {
    if (!active_ || isLinkDown()) return;
    if (goalToSend_) {
        active_->since_s = now_s_;
        link_.sendGoal(*std::exchange(goalToSend_, std::nullopt));
    }
    if (photoToAsk_) {
        active_->since_s = now_s_;
        link_.requestPhoto(*std::exchange(photoToAsk_, std::nullopt));
    }
}

void VisitRunner::checkLink() {
    if (!active_ || !isLinkDown() || now_s_ - *linkDownSince_s_ < settings_.linkTimeout_s) return;
    holdFor(VisitReason::LinkLost, "for " + seconds(now_s_ - *linkDownSince_s_));
}

void VisitRunner::checkActive() {
    if (active_->pausedUntil_s) {
        if (now_s_ < *active_->pausedUntil_s) return;
        active_->pausedUntil_s.reset();
        if (activeVisit().state == VisitState::Photo) {
            requestPhoto();
        } else {
            sendGoal();
        }
        return;
    }
    // What has not been sent cannot be late.
    if (goalToSend_ || photoToAsk_) return;
    const double waited_s = now_s_ - active_->since_s;
    switch (activeVisit().state) {
        case VisitState::Sent:
            if (waited_s >= settings_.acknowledgeTimeout_s) driveFailed(VisitReason::NotAcknowledged, "");
            break;
        case VisitState::Accepted:
        case VisitState::Driving:
            checkDrive(waited_s);
            break;
        case VisitState::Arrived:
            checkArrival(waited_s);
            break;
        case VisitState::Photo:
            if (waited_s >= settings_.photoTimeout_s) photoFailed(VisitReason::PhotoLate, "");
            break;
        default:
            break;
    }
}

void VisitRunner::checkDrive(double waited_s) {
    const auto isOld = [&](const std::optional<double>& since_s) {
        return since_s && robotTold_s_ - *since_s >= settings_.acknowledgeTimeout_s;
    };
    if (isOld(active_->stranger_s)) {
        holdFor(VisitReason::Preempted, "the robot works on " + robot_->goalId.value_or(""));
    } else if (!active_->stranger_s && isOld(active_->named_s)) {
        // The answer may have been lost, not the goal.
        const std::optional<Pose2> stands_map = standsAt_map();
        const bool isThere =
            stands_map && !robot_->moving && !arrivalProblem(*stands_map, *activeWaypoint().pose_map, settings_);
        if (isThere) {
            say(activeVisit().waypointId + ": the robot stands there and works on no goal, so it has arrived");
            arrive(std::nullopt);
        } else {
            driveFailed(VisitReason::GoalForgotten, "");
        }
    } else if (waited_s >= settings_.driveTimeout_s) {
        driveFailed(VisitReason::NotArrived, "");
    } else if (activeVisit().state == VisitState::Accepted && robot_ && waited_s >= settings_.departureTimeout_s) {
        driveFailed(VisitReason::NotDeparted, "");
    }
}

/// @return where the robot stands as far as that is known now
std::optional<Pose2> VisitRunner::standsAt_map() const {
    if (!robot_) return active_->saysItStands_map;
    if (!robot_->pose_map || !isFinite(*robot_->pose_map)) return std::nullopt;
    const bool isFresh = now_s_ - robot_->poseMeasured_s <= settings_.maximumPoseAge_s;
    return isFresh ? robot_->pose_map : std::nullopt;
}

void VisitRunner::checkArrival(double waited_s) {
    const bool toldSince = !robot_ || robotTold_s_ >= active_->since_s;
    const std::optional<Pose2> stands_map = toldSince ? standsAt_map() : std::nullopt;
    if (!stands_map) {
        if (waited_s >= settings_.localiseTimeout_s) holdFor(VisitReason::NotLocalised, "");
        return;
    }
    if (const auto problem = arrivalProblem(*stands_map, *activeWaypoint().pose_map, settings_)) {
        driveFailed(problem->reason, problem->detail);
    } else if (activeWaypoint().takesPhoto) {
        requestPhoto();
    } else {
        endVisit(VisitState::Done);
    }
}

/// Cancels get lost on a bad link: repeat until the robot names the stopped goal no more.
void VisitRunner::sendCancelAgain() {
    if (!stoppedGoalIsAlive_ || isLinkDown() || active_) return;
    if (now_s_ - stopSent_s_ < std::ldexp(settings_.cancelTimeout_s, std::min(cancelsSent_ - 1, 4))) return;
    if (cancelsSent_ <= settings_.maximumTries) {
        say("the robot still works on " + stoppedGoalId_ + "; the stop was sent again");
    } else if (cancelsSent_ == settings_.maximumTries + 1) {
        say("the robot does not obey the stop of " + stoppedGoalId_ + ": stop it by hand");
        if (runnerState_ == RunnerState::Running) runnerState_ = RunnerState::Paused;
    }
    link_.cancelAllGoals();
    stopSent_s_ = now_s_;
    ++cancelsSent_;
}

void VisitRunner::begin() {
    if (active_ || runnerState_ == RunnerState::Idle || runnerState_ == RunnerState::Finished) return;
    const auto next = std::find_if(visits_.begin(), visits_.end(),
                                   [](const Visit& visit) { return visit.state == VisitState::Draft; });
    if (next == visits_.end()) {
        runnerState_ = RunnerState::Finished;
        return;
    }
    if (runnerState_ != RunnerState::Running || !mayBegin(*next)) return;
    active_ = Active{};
    active_->index = static_cast<std::size_t>(next - visits_.begin());
    active_->since_s = now_s_;
    if (!takeUpAgain(*next)) sendGoal();
}

bool VisitRunner::mayBegin(Visit& next) {
    if (now_s_ < quietUntil_s_ || stoppedGoalIsAlive_) return false;
    // A link that has not said anything yet may be up; one that says it is not would lose the goal.
    if (isLinkDown()) return false;
    // Whether the robot still works on the goal of an interrupted visit is for the robot to tell.
    const bool isRecorded = !next.goalId.empty() && next.reason == VisitReason::Interrupted;
    if (isRecorded && !robot_ && now_s_ - *runningSince_s_ < settings_.acknowledgeTimeout_s) return false;
    const double offset_s = robot_ ? robot_->clockOffset_s.value_or(0.0) : 0.0;
    if (!(std::abs(offset_s) > settings_.maximumClockOffset_s)) return true;
    const std::string detail = "it is " + seconds(std::abs(offset_s)) + (offset_s > 0.0 ? " ahead" : " behind");
    say("holding before " + next.waypointId + ": " + because(toString(VisitReason::ClockOff), detail));
    setState(next, VisitState::Draft, VisitReason::ClockOff, detail);
    runnerState_ = RunnerState::Paused;
    return false;
}

/// Goes on with a drive that the robot was given before this program started, or before the link was lost.
bool VisitRunner::takeUpAgain(const Visit& next) {
    const bool isAtIt =
        robot_ && !next.goalId.empty() && robot_->goalId == next.goalId && next.goalId != stoppedGoalId_;
    if (!isAtIt) return false;
    say(next.waypointId + ": the robot is still on its way");
    active_->tries = 1;
    active_->goalIds = {next.goalId};
    active_->named_s = robotTold_s_;
    setState(activeVisit(), VisitState::Accepted);
    return true;
}

void VisitRunner::sendGoal() {
    Visit& visit = activeVisit();
    ++visit.tries;
    visit.photoTries = 0;
    ++active_->tries;
    active_->named_s.reset();
    active_->stranger_s.reset();
    visit.goalId = visit.waypointId + "/" + std::to_string(visit.tries);
    active_->goalIds.push_back(visit.goalId);
    setState(visit, VisitState::Sent);
    stoppedGoalIsAlive_ = false;
    goalToSend_ = RobotGoal{visit.goalId, *activeWaypoint().pose_map};
}

void VisitRunner::requestPhoto() {
    Visit& visit = activeVisit();
    ++visit.photoTries;
    active_->photoIds.push_back(visit.goalId + "/photo-" + std::to_string(visit.photoTries));
    setState(visit, VisitState::Photo);
    photoToAsk_ = active_->photoIds.back();
}

void VisitRunner::driveFailed(VisitReason reason, const std::string& detail) {
    const std::string text = activeVisit().waypointId + " " + because(toString(reason), detail);
    // Only a goal whose answer is missing may still come to life.
    if (reason != VisitReason::NotAcknowledged) active_->goalIds.clear();
    if (active_->tries < settings_.maximumTries) {
        say(text + "; tried again");
        // No cancel before it: the new goal replaces the old one, and a late cancel would take the new one with it.
        active_->pausedUntil_s = now_s_ + retryPause_s(settings_, active_->tries);
        setState(activeVisit(), VisitState::Draft, reason, detail);
        return;
    }
    // The robot may still be on its way when only its answer is missing.
    const bool mayDrive = reason == VisitReason::NotAcknowledged || reason == VisitReason::NotArrived ||
                          reason == VisitReason::NotDeparted || reason == VisitReason::GoalForgotten;
    if (mayDrive) {
        cancelOnRobot();
        quietUntil_s_ = now_s_ + kCancelSettles_s;
    }
    endVisit(VisitState::Failed, reason, detail);
}

void VisitRunner::photoFailed(VisitReason reason, const std::string& detail) {
    if (activeVisit().photoTries < settings_.maximumPhotoTries) {
        say(activeVisit().waypointId + " " + because(toString(reason), detail) + "; asked again");
        active_->pausedUntil_s = now_s_ + retryPause_s(settings_, activeVisit().photoTries);
        setState(activeVisit(), VisitState::Photo, reason, detail);
        return;
    }
    endVisit(VisitState::Failed, reason, detail);
}

void VisitRunner::holdFor(VisitReason reason, const std::string& detail) {
    say("holding at " + activeVisit().waypointId + ": " + because(toString(reason), detail));
    endVisit(VisitState::Draft, reason, detail);
    if (runnerState_ == RunnerState::Running) runnerState_ = RunnerState::Paused;
}

/// Ends the visit under way.
void VisitRunner::endVisit(VisitState state, VisitReason reason, const std::string& detail) {
    Visit& visit = activeVisit();
    active_.reset();
    goalToSend_.reset();
    photoToAsk_.reset();
    setState(visit, state, reason, detail);
}

void VisitRunner::cancelOnRobot() {
    if (active_) stoppedGoalId_ = activeVisit().goalId;
    link_.cancelAllGoals();
    stopSent_s_ = now_s_;
    cancelsSent_ = 1;
}

}  // namespace fodscope
