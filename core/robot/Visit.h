// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/common/Geometry.h"

namespace fodscope {

/// A visit is a transaction: Draft → Sent → Accepted → Driving → Arrived → Photo → Done. Draft is also where it waits
/// for another try, with the reason of the one before. Skipped was not driven on purpose, Failed in spite of all tries.
enum class VisitState { Draft, Sent, Accepted, Driving, Arrived, Photo, Done, Failed, Skipped };

/// Why a visit is where it is: the closed set of reasons.
enum class VisitReason {
    None,
    // The drive went wrong: tried again, then failed.
    NotAcknowledged,
    Rejected,
    Aborted,
    GoalForgotten,
    NotDeparted,
    NotArrived,
    ArrivedElsewhere,
    // The photo went wrong: asked for again, then failed.
    PhotoMissing,
    PhotoLate,
    PhotoCorrupt,
    PhotoBlank,
    PhotoRepeated,
    PhotoOfAnotherPlace,
    PhotoOfAnotherTime,
    // Back in Draft, and a person has to look.
    LinkLost,
    Preempted,
    StoppedAtRobot,
    StoppedByOperator,
    NotLocalised,
    ClockOff,
    Interrupted,
    // Skipped.
    SkippedByOperator,
    NoPose,
    /// Kept by a version that had no closed set; the detail tells.
    NotRecorded
};

/// @return the word shown to people, e.g. "driving"
std::string toString(VisitState state);

/// @return the reason in words, e.g. "given up by the robot"; empty for None and NotRecorded
std::string toString(VisitReason reason);

/// One drive to a waypoint and its photo.
struct Visit {
    std::string waypointId;
    VisitState state = VisitState::Draft;
    /// Goal of the latest try; empty before the first.
    std::string goalId;
    VisitReason reason = VisitReason::None;
    /// What is known beyond the reason, e.g. what the robot said.
    std::string detail;
    /// Goals sent.
    int tries = 0;
    /// Photos asked for, with the latest goal.
    int photoTries = 0;

    bool operator==(const Visit&) const = default;
};

/// @return reason and detail as one phrase, e.g. "given up by the robot: no path"; empty without a reason
std::string reasonText(const Visit& visit);

/// @return whether the robot has it in hand: from Sent to Photo
bool isUnderWay(VisitState state);

/// @return whether nothing more happens to it by itself: Done, Failed or Skipped
bool isOver(VisitState state);

/// How long each step of a visit may take, and how often it is tried.
struct VisitSettings {
    /// Sent → Accepted. A goal that the robot has not confirmed within this time counts as not acknowledged.
    double acknowledgeTimeout_s = 3.0;
    /// Accepted → Driving, where the robot tells whether it moves.
    double departureTimeout_s = 30.0;
    /// Accepted or Driving → Arrived.
    double driveTimeout_s = 120.0;
    /// Arrived → Photo: until the robot knows where it stands.
    double localiseTimeout_s = 5.0;
    /// Photo → Done.
    double photoTimeout_s = 10.0;
    /// A link that is back within this time is as if it had never been lost.
    double linkTimeout_s = 15.0;
    /// Until a cancel that the robot has not obeyed is sent again.
    double cancelTimeout_s = 3.0;
    /// Tries of a drive, and of a photo.
    int maximumTries = 2;
    int maximumPhotoTries = 2;
    /// Pause before the second try; twice as long before each further one.
    double retryPause_s = 1.0;
    /// A robot that stands farther from its goal has not arrived there.
    double arrivalTolerance_m = 0.3;
    double arrivalTolerance_rad = radiansFromDegrees(20.0);
    /// An older pose is not known any more.
    double maximumPoseAge_s = 2.0;
    /// The robot's clock may be this far from the computer's, and a photo's time from the visit.
    double maximumClockOffset_s = 5.0;
    /// A camera farther from the waypoint took another place.
    double cameraReach_m = 0.75;
    /// Grey levels, of 255, that a photo must have between its darkest and its brightest parts.
    double leastContrast = 4.0;

    bool operator==(const VisitSettings&) const = default;
};

/// @throws Error when a value is out of range
void requireInRange(const VisitSettings& settings);

/// @return the pause before the try after `triesMade`, not longer than a minute
double retryPause_s(const VisitSettings& settings, int triesMade);

/// What a later visit must know of a photo that is kept already.
struct PhotoMark {
    /// The request that it answered; it begins with the goal's id. Empty in sessions of the first version.
    std::string requestId;
    std::string sha256;
};

/// The visits of a program that ended without notice, as they go on. The rule: a visit that was under way is Done when
/// a photo of its latest goal is kept, because the photo is always kept before the visit is called done. Else it is
/// Draft again, as interrupted; its next goal has a new id, so that no answer to the old one is mistaken for one to the
/// new, unless the robot still works on the old one: then that is gone on with.
std::vector<Visit> resumedVisits(std::vector<Visit> visits, const std::vector<PhotoMark>& kept);

}  // namespace fodscope
