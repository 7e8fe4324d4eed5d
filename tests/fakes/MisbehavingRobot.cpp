// SPDX-License-Identifier: MIT
#include "tests/fakes/MisbehavingRobot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/fakes/ScriptedRobotLink.h"

namespace fodscope::test {
namespace {

constexpr double kSpeed_m_per_s = 1.0;
constexpr double kConfirms_s = 0.2;
constexpr double kExposes_s = 0.5;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::vector<std::byte> blackPhoto() {
    std::vector<unsigned char> encoded;
    cv::imencode(".jpg", cv::Mat(24, 32, CV_8UC3, cv::Scalar(2, 2, 2)), encoded);
    const auto* first = reinterpret_cast<const std::byte*>(encoded.data());
    return {first, first + encoded.size()};
}

}  // namespace

UtcTime MisbehavingRobot::utcAt(double now_s) const {
    return {epoch_.milliseconds + std::llround(1000.0 * now_s)};
}

void MisbehavingRobot::say(RobotEvent event) {
    if (now_s_ < linkBack_s_) return;
    const int times = does(Misbehaviour::DuplicateAnswers) ? 3 : 1;
    for (int i = 0; i < times; ++i)
        events_.push_back(event);
}

void MisbehavingRobot::dropLink(double duration_s) {
    hasDroppedLink_ = true;
    linkBack_s_ = now_s_ + duration_s;
}

void MisbehavingRobot::restart() {
    drive_.reset();
    exposures_.clear();
    events_.clear();
}

void MisbehavingRobot::sendGoal(const RobotGoal& goal) {
    if (now_s_ < linkBack_s_) return;
    goalsReceived.push_back(goal.id);
    const bool isFaulty = goal.id.starts_with("W-01");
    if (does(Misbehaviour::NoAcknowledgement) && isFaulty) return;
    if (does(Misbehaviour::FirstGoalLost) && goal.id == "W-01/1") return;
    if (does(Misbehaviour::Rejects) && isFaulty) {
        say(GoalFailed{goal.id, GoalFailure::Rejected, "the quaternion is not upright"});
        return;
    }
    if (drive_ && drive_->isConfirmed) say(GoalFailed{drive_->goal.id, GoalFailure::Preempted, "a newer goal came"});
    drive_ = Drive{goal, now_s_, false, 0.0, 0.0, false};
    drive_->length_m = std::hypot(goal.pose_map.x_m - pose_map_.x_m, goal.pose_map.y_m - pose_map_.y_m);
    strangersGoal_.reset();
}

void MisbehavingRobot::cancelAllGoals() {
    ++cancels;
    if (now_s_ < linkBack_s_ || does(Misbehaviour::DisobeysCancel)) return;
    if (drive_) say(GoalFailed{drive_->goal.id, GoalFailure::StopRequested, ""});
    drive_.reset();
    strangersGoal_.reset();
}

void MisbehavingRobot::requestPhoto(const std::string& requestId) {
    if (now_s_ < linkBack_s_) return;
    photosAsked.push_back(requestId);
    const bool isFaulty = requestId.starts_with("W-01");
    const bool isLate = does(Misbehaviour::PhotoLate) && requestId == "W-01/1/photo-1";
    if (does(Misbehaviour::PhotoNever) && isFaulty) return;
    if (does(Misbehaviour::LinkDropsBeforePhoto) && !hasDroppedLink_) {
        dropLink(6.0);
        return;
    }
    exposures_.push_back({requestId, now_s_ + (isLate ? 12.0 : kExposes_s)});
}

std::vector<RobotEvent> MisbehavingRobot::poll(double now_s) {
    const double passed_s = std::max(0.0, now_s - now_s_);
    now_s_ = std::max(now_s, now_s_);
    if (drive_) confirm();
    if (drive_ && drive_->isConfirmed) drive(passed_s);
    develop();
    RobotState told = state();
    if (now_s_ < linkBack_s_) {
        told = {};
        told.link = LinkState::Lost;
        events_.emplace_back(RobotStateChanged{told});
    } else {
        say(RobotStateChanged{told});
    }
    return std::exchange(events_, {});
}

void MisbehavingRobot::confirm() {
    const bool isLate = does(Misbehaviour::LateAcknowledgement) && isFirstDrive();
    if (drive_->isConfirmed || now_s_ < drive_->sent_s + (isLate ? 3.5 : kConfirms_s)) return;
    drive_->isConfirmed = true;
    if (does(Misbehaviour::WrongId) && isFaultyDrive()) drive_->goal.id = "move_base-17";
    const bool isSilent = does(Misbehaviour::AcknowledgesAfterArrival) && isFaultyDrive();
    if (!isSilent) say(GoalAccepted{drive_->goal.id});
}

void MisbehavingRobot::drive(double duration_s) {
    const bool isStuck = does(Misbehaviour::NeverSetsOut) && isFaultyDrive();
    if (isStuck) return;
    drive_->driven_m += kSpeed_m_per_s * duration_s;
    if (isFaultyDrive() && !drive_->hasHadItsFault && drive_->driven_m >= 0.5 * drive_->length_m) {
        drive_->hasHadItsFault = true;
        misbehaveHalfWay();
        if (!drive_) return;
    }
    const bool isEndless = (does(Misbehaviour::NeverArrives) || does(Misbehaviour::DisobeysCancel)) && isFaultyDrive();
    const double left_m = drive_->length_m - drive_->driven_m;
    if (left_m > 0.0 || isEndless) {
        const Pose2& goal = drive_->goal.pose_map;
        const double share =
            std::clamp(kSpeed_m_per_s * duration_s / std::max(left_m + kSpeed_m_per_s * duration_s, 1e-9), 0.0,
                       isEndless ? 0.1 : 1.0);
        pose_map_.x_m += share * (goal.x_m - pose_map_.x_m);
        pose_map_.y_m += share * (goal.y_m - pose_map_.y_m);
        return;
    }
    arrive();
}

void MisbehavingRobot::misbehaveHalfWay() {
    const std::string id = drive_->goal.id;
    const auto end = [&](GoalFailure failure, const std::string& message) {
        drive_.reset();
        say(GoalFailed{id, failure, message});
    };
    switch (misbehaviour_) {
        case Misbehaviour::AbortsOnce:
            if (isFirstDrive()) end(GoalFailure::Aborted, "no valid path");
            break;
        case Misbehaviour::AbortsAlways:
            end(GoalFailure::Aborted, "no valid path");
            break;
        case Misbehaviour::Preempted:
            if (isFirstDrive()) end(GoalFailure::Preempted, "a goal from rviz");
            break;
        case Misbehaviour::TakenOverSilently:
            if (!isFirstDrive()) break;
            drive_.reset();
            strangersGoal_ = "rviz-3";
            break;
        case Misbehaviour::StoppedAtRobot:
            if (isFirstDrive()) end(GoalFailure::StopRequested, "the red button");
            break;
        case Misbehaviour::ForgetsTheGoal:
            if (isFirstDrive()) drive_.reset();
            break;
        case Misbehaviour::Restarts:
            if (!isFirstDrive()) break;
            restart();
            dropLink(2.0);
            break;
        case Misbehaviour::LinkDropsAndReturns:
            if (isFirstDrive()) dropLink(1.0);
            break;
        case Misbehaviour::LinkDropsForLong:
            if (isFirstDrive()) dropLink(40.0);
            break;
        case Misbehaviour::ArrivalLost:
            if (isFirstDrive()) dropLink(8.0);
            break;
        case Misbehaviour::AnswersGarbage:
            if (!isFirstDrive()) break;
            say(GoalAccepted{std::string("\xff\0\xfe", 3)});
            say(GoalArrived{"", {kNaN, kNaN, kNaN}});
            say(PhotoReceived{"", {}});
            say(PhotoFailed{"W-01/1/photo-1", static_cast<PhotoFailure>(77), "?"});
            say(LinkMessage{std::string("\0\x01\xc3\x28", 4)});
            say(RobotStateChanged{{LinkState::Connected, Pose2{kNaN, 0.0, kNaN}, kNaN, true, "", kNaN, kNaN}});
            end(static_cast<GoalFailure>(99), "\xc3\x28");
            break;
        default:
            break;
    }
}

void MisbehavingRobot::arrive() {
    const RobotGoal goal = drive_->goal;
    const bool isElsewhere = (does(Misbehaviour::ArrivesElsewhereOnce) && isFirstDrive()) ||
                             (does(Misbehaviour::ArrivesElsewhere) && isFaultyDrive());
    const bool isFaulty = isFaultyDrive();
    const bool isFirst = isFirstDrive();
    pose_map_ = goal.pose_map;
    if (isElsewhere) pose_map_.x_m -= 0.8;
    drive_.reset();
    say(GoalArrived{goal.id, goal.pose_map});
    if (does(Misbehaviour::AcknowledgesAfterArrival) && isFaulty) say(GoalAccepted{goal.id});
    isLost_ = does(Misbehaviour::LosesItself) && isFirst;
    poseFrozen_s_.reset();
    if (does(Misbehaviour::PoseFrozen) && isFirst) poseFrozen_s_ = now_s_ - 5.0;
}

void MisbehavingRobot::develop() {
    const auto due = std::stable_partition(exposures_.begin(), exposures_.end(),
                                           [&](const Exposure& exposure) { return exposure.due_s > now_s_; });
    const std::vector<Exposure> now(due, exposures_.end());
    exposures_.erase(due, exposures_.end());
    for (const Exposure& exposure : now)
        answer(exposure);
}

void MisbehavingRobot::answer(const Exposure& exposure) {
    Photo photo = photoFor(exposure.requestId);
    std::string requestId = exposure.requestId;
    if (!requestId.starts_with("W-01")) {
        say(PhotoReceived{requestId, photo});
        return;
    }
    switch (misbehaviour_) {
        case Misbehaviour::PhotoMissing:
            say(PhotoFailed{requestId, PhotoFailure::Missing, "the camera does not answer"});
            return;
        case Misbehaviour::PhotoTruncated:
            photo.bytes.resize(photo.bytes.size() / 2);
            break;
        case Misbehaviour::PhotoTruncatedOnce:
            if (photosTaken_ == 1) photo.bytes.resize(photo.bytes.size() / 2);
            break;
        case Misbehaviour::PhotoBlack:
            photo.bytes = blackPhoto();
            break;
        case Misbehaviour::PhotoOfAnotherRequest:
            requestId = "W-02/1/photo-1";
            break;
        case Misbehaviour::PhotoOfAnotherWaypoint:
            photo.waypointId = "W-02";
            break;
        case Misbehaviour::PhotoFromElsewhere:
            photo.T_map_from_camera.translation().x() += 2.0;
            break;
        case Misbehaviour::PhotoOfYesterday:
            photo.taken.milliseconds -= 24 * 3600 * 1000;
            break;
        case Misbehaviour::TwoPhotos:
            say(PhotoReceived{requestId, photoFor(requestId)});
            break;
        default:
            break;
    }
    say(PhotoReceived{requestId, photo});
}

Photo MisbehavingRobot::photoFor(const std::string& requestId) {
    ++photosTaken_;
    Photo photo;
    photo.taken = utcAt(now_s_);
    photo.T_map_from_camera = transformFromPose(pose_map_);
    photo.intrinsics = {32, 24, 30.0, 30.0, 16.0, 12.0};
    photo.mediaType = "image/jpeg";
    const bool isFrozen = does(Misbehaviour::PhotoFrozen) && requestId.starts_with("W-02");
    photo.bytes = photoBytes(".jpg", isFrozen ? 1 : photosTaken_);
    return photo;
}

RobotState MisbehavingRobot::state() const {
    RobotState state;
    state.link = LinkState::Connected;
    if (!isLost_) state.pose_map = pose_map_;
    state.poseMeasured_s = poseFrozen_s_.value_or(now_s_);
    state.moving = drive_ && drive_->isConfirmed && !(does(Misbehaviour::NeverSetsOut) && isFaultyDrive());
    if (drive_ && drive_->isConfirmed) state.goalId = drive_->goal.id;
    // A robot that confirms late says so nowhere.
    if (does(Misbehaviour::AcknowledgesAfterArrival) && isFaultyDrive()) state.goalId.reset();
    if (strangersGoal_) {
        state.goalId = strangersGoal_;
        state.moving = true;
    }
    state.clockOffset_s = does(Misbehaviour::ClockOff) && now_s_ < 20.0 ? 61.0 : 0.25;
    return state;
}

const std::vector<std::pair<Misbehaviour, std::string>>& misbehaviours() {
    using enum Misbehaviour;
    static const std::vector<std::pair<Misbehaviour, std::string>> kAll{
        {None, "behaves"},
        {NoAcknowledgement, "noAcknowledgement"},
        {FirstGoalLost, "firstGoalLost"},
        {WrongId, "wrongId"},
        {LateAcknowledgement, "lateAcknowledgement"},
        {DuplicateAnswers, "duplicateAnswers"},
        {AcknowledgesAfterArrival, "acknowledgesAfterArrival"},
        {Rejects, "rejects"},
        {NeverSetsOut, "neverSetsOut"},
        {ClockOff, "clockOff"},
        {AbortsOnce, "abortsOnce"},
        {AbortsAlways, "abortsAlways"},
        {Preempted, "preempted"},
        {TakenOverSilently, "takenOverSilently"},
        {StoppedAtRobot, "stoppedAtRobot"},
        {NeverArrives, "neverArrives"},
        {DisobeysCancel, "disobeysCancel"},
        {ForgetsTheGoal, "forgetsTheGoal"},
        {Restarts, "restarts"},
        {LinkDropsAndReturns, "linkDropsAndReturns"},
        {LinkDropsForLong, "linkDropsForLong"},
        {ArrivalLost, "arrivalLost"},
        {AnswersGarbage, "answersGarbage"},
        {ArrivesElsewhereOnce, "arrivesElsewhereOnce"},
        {ArrivesElsewhere, "arrivesElsewhere"},
        {LosesItself, "losesItself"},
        {PoseFrozen, "poseFrozen"},
        {LinkDropsBeforePhoto, "linkDropsBeforePhoto"},
        {PhotoMissing, "photoMissing"},
        {PhotoNever, "photoNever"},
        {PhotoLate, "photoLate"},
        {PhotoTruncated, "photoTruncated"},
        {PhotoTruncatedOnce, "photoTruncatedOnce"},
        {PhotoBlack, "photoBlack"},
        {PhotoFrozen, "photoFrozen"},
        {PhotoOfAnotherRequest, "photoOfAnotherRequest"},
        {PhotoOfAnotherWaypoint, "photoOfAnotherWaypoint"},
        {PhotoFromElsewhere, "photoFromElsewhere"},
        {PhotoOfYesterday, "photoOfYesterday"},
        {TwoPhotos, "twoPhotos"}};
    return kAll;
}

}  // namespace fodscope::test
