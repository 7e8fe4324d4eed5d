// SPDX-License-Identifier: MIT
#include "storage/Words.h"

#include <array>
#include <stdexcept>
#include <utility>

namespace fodscope {
namespace {

template <typename Enum, std::size_t Count>
using Table = std::array<std::pair<Enum, const char*>, Count>;

constexpr Table<RegistrationQuality, 4> kQualities{{{RegistrationQuality::Given, "given"},
                                                    {RegistrationQuality::Good, "good"},
                                                    {RegistrationQuality::Ambiguous, "ambiguous"},
                                                    {RegistrationQuality::Bad, "bad"}}};
constexpr Table<WaypointStatus, 9> kStatuses{{{WaypointStatus::Ok, "ok"},
                                              {WaypointStatus::Unreachable, "unreachable"},
                                              {WaypointStatus::Hidden, "hidden"},
                                              {WaypointStatus::TooCloseToWall, "too close to wall"},
                                              {WaypointStatus::OutsideGrid, "outside grid"},
                                              {WaypointStatus::TooHigh, "too high"},
                                              {WaypointStatus::TooNear, "too near"},
                                              {WaypointStatus::TooFar, "too far"},
                                              {WaypointStatus::LeftOut, "left out"}}};
constexpr Table<VisitState, 9> kVisits{{{VisitState::Draft, "draft"},
                                        {VisitState::Sent, "sent"},
                                        {VisitState::Accepted, "accepted"},
                                        {VisitState::Driving, "driving"},
                                        {VisitState::Arrived, "arrived"},
                                        {VisitState::Photo, "photo"},
                                        {VisitState::Done, "done"},
                                        {VisitState::Failed, "failed"},
                                        {VisitState::Skipped, "skipped"}}};
constexpr Table<VisitReason, 25> kReasons{{{VisitReason::None, ""},
                                           {VisitReason::NotAcknowledged, "not acknowledged"},
                                           {VisitReason::Rejected, "rejected"},
                                           {VisitReason::Aborted, "aborted"},
                                           {VisitReason::GoalForgotten, "goal forgotten"},
                                           {VisitReason::NotDeparted, "not departed"},
                                           {VisitReason::NotArrived, "not arrived"},
                                           {VisitReason::ArrivedElsewhere, "arrived elsewhere"},
                                           {VisitReason::PhotoMissing, "photo missing"},
                                           {VisitReason::PhotoLate, "photo late"},
                                           {VisitReason::PhotoCorrupt, "photo corrupt"},
                                           {VisitReason::PhotoBlank, "photo blank"},
                                           {VisitReason::PhotoRepeated, "photo repeated"},
                                           {VisitReason::PhotoOfAnotherPlace, "photo of another place"},
                                           {VisitReason::PhotoOfAnotherTime, "photo of another time"},
                                           {VisitReason::LinkLost, "link lost"},
                                           {VisitReason::Preempted, "preempted"},
                                           {VisitReason::StoppedAtRobot, "stopped at robot"},
                                           {VisitReason::StoppedByOperator, "stopped by operator"},
                                           {VisitReason::NotLocalised, "not localised"},
                                           {VisitReason::ClockOff, "clock off"},
                                           {VisitReason::Interrupted, "interrupted"},
                                           {VisitReason::SkippedByOperator, "skipped by operator"},
                                           {VisitReason::NoPose, "no pose"},
                                           {VisitReason::NotRecorded, "not recorded"}}};
constexpr Table<LabelKind, 3> kKinds{
    {{LabelKind::Fod, "fod"}, {LabelKind::NoFod, "no fod"}, {LabelKind::NotSure, "not sure"}}};

template <typename Enum, std::size_t Count>
std::string word(const Table<Enum, Count>& table, Enum value) {
    for (const auto& [known, text] : table) {
        if (known == value) return text;
    }
    throw std::logic_error("an enumerator has no word in the session format");
}

template <typename Enum, std::size_t Count>
Enum value(const Table<Enum, Count>& table, const std::string& text) {
    for (const auto& [known, word] : table) {
        if (text == word) return known;
    }
    throw std::invalid_argument("unknown word \"" + text + "\"");
}

}  // namespace

std::string wordOf(RegistrationQuality quality) {
    return word(kQualities, quality);
}
std::string wordOf(WaypointStatus status) {
    return word(kStatuses, status);
}
std::string wordOf(VisitState state) {
    return word(kVisits, state);
}
std::string wordOf(VisitReason reason) {
    return word(kReasons, reason);
}
std::string wordOf(LabelKind kind) {
    return word(kKinds, kind);
}

RegistrationQuality qualityOf(const std::string& word) {
    return value(kQualities, word);
}
WaypointStatus waypointStatusOf(const std::string& word) {
    return value(kStatuses, word);
}
VisitState visitStateOf(const std::string& word) {
    return value(kVisits, word);
}
VisitReason visitReasonOf(const std::string& word) {
    return value(kReasons, word);
}
LabelKind labelKindOf(const std::string& word) {
    return value(kKinds, word);
}

}  // namespace fodscope
