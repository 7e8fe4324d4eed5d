// SPDX-License-Identifier: MIT
#include "core/robot/Visit.h"

#include <algorithm>
#include <cmath>

#include "core/common/Error.h"

namespace fodscope {

std::string toString(VisitState state) {
    switch (state) {
        case VisitState::Draft:
            return "draft";
        case VisitState::Sent:
            return "sent";
        case VisitState::Accepted:
            return "accepted";
        case VisitState::Driving:
            return "driving";
        case VisitState::Arrived:
            return "arrived";
        case VisitState::Photo:
            return "photo";
        case VisitState::Done:
            return "done";
        case VisitState::Failed:
            return "failed";
        case VisitState::Skipped:
            return "skipped";
    }
    return "unknown";
}

std::string toString(VisitReason reason) {
    switch (reason) {
        case VisitReason::None:
        case VisitReason::NotRecorded:
            return "";
        case VisitReason::NotAcknowledged:
            return "not confirmed by the robot";
        case VisitReason::Rejected:
            return "rejected by the robot";
        case VisitReason::Aborted:
            return "given up by the robot";
        case VisitReason::GoalForgotten:
            return "the robot no longer knows the goal";
        case VisitReason::NotDeparted:
            return "the robot did not set out";
        case VisitReason::NotArrived:
            return "not arrived in time";
        case VisitReason::ArrivedElsewhere:
            return "the robot stands elsewhere";
        case VisitReason::PhotoMissing:
            return "the robot has no photo";
        case VisitReason::PhotoLate:
            return "no photo in time";
        case VisitReason::PhotoCorrupt:
            return "the photo is damaged";
        case VisitReason::PhotoBlank:
            return "the photo shows nothing";
        case VisitReason::PhotoRepeated:
            return "the photo is one that came before";
        case VisitReason::PhotoOfAnotherPlace:
            return "the photo was taken elsewhere";
        case VisitReason::PhotoOfAnotherTime:
            return "the photo was not taken during the visit";
        case VisitReason::LinkLost:
            return "link lost";
        case VisitReason::Preempted:
            return "replaced by another goal";
        case VisitReason::StoppedAtRobot:
            return "stopped at the robot";
        case VisitReason::StoppedByOperator:
            return "stopped by the operator";
        case VisitReason::NotLocalised:
            return "the robot does not know where it is";
        case VisitReason::ClockOff:
            return "the robot's clock is wrong";
        case VisitReason::Interrupted:
            return "interrupted";
        case VisitReason::SkippedByOperator:
            return "skipped by the operator";
        case VisitReason::NoPose:
            return "no waypoint";
    }
    return "unknown";
}

std::string reasonText(const Visit& visit) {
    const std::string reason = toString(visit.reason);
    if (reason.empty() || visit.detail.empty()) return reason + visit.detail;
    return reason + ": " + visit.detail;
}

bool isUnderWay(VisitState state) {
    return state == VisitState::Sent || state == VisitState::Accepted || state == VisitState::Driving ||
           state == VisitState::Arrived || state == VisitState::Photo;
}

bool isOver(VisitState state) {
    return state == VisitState::Done || state == VisitState::Failed || state == VisitState::Skipped;
}

void requireInRange(const VisitSettings& settings) {
    const auto isOverZero = [](double value) { return value > 0.0 && std::isfinite(value); };
    const auto isZeroOrMore = [](double value) { return value >= 0.0 && std::isfinite(value); };
    const bool timeouts = isOverZero(settings.acknowledgeTimeout_s) && isOverZero(settings.departureTimeout_s) &&
                          isOverZero(settings.driveTimeout_s) && isOverZero(settings.localiseTimeout_s) &&
                          isOverZero(settings.photoTimeout_s) && isOverZero(settings.linkTimeout_s) &&
                          isOverZero(settings.cancelTimeout_s);
    const bool limits = isOverZero(settings.arrivalTolerance_m) && isOverZero(settings.arrivalTolerance_rad) &&
                        isOverZero(settings.maximumPoseAge_s) && isOverZero(settings.maximumClockOffset_s) &&
                        isOverZero(settings.cameraReach_m) && isZeroOrMore(settings.leastContrast);
    const bool tries =
        settings.maximumTries >= 1 && settings.maximumPhotoTries >= 1 && isZeroOrMore(settings.retryPause_s);
    if (timeouts && limits && tries) return;
    throw Error("visit settings", "a value is out of range", "give times over 0 s and at least 1 try");
}

double retryPause_s(const VisitSettings& settings, int triesMade) {
    constexpr double kLongest_s = 60.0;
    return std::min(std::ldexp(settings.retryPause_s, std::clamp(triesMade - 1, 0, 16)),
                    std::max(kLongest_s, settings.retryPause_s));
}

std::vector<Visit> resumedVisits(std::vector<Visit> visits, const std::vector<PhotoMark>& kept) {
    for (Visit& visit : visits) {
        if (!isUnderWay(visit.state)) continue;
        const bool hasPhoto = !visit.goalId.empty() && std::ranges::any_of(kept, [&](const PhotoMark& mark) {
            return mark.requestId.starts_with(visit.goalId + "/");
        });
        visit.state = hasPhoto ? VisitState::Done : VisitState::Draft;
        visit.reason = hasPhoto ? VisitReason::None : VisitReason::Interrupted;
        visit.detail.clear();
    }
    return visits;
}

}  // namespace fodscope
