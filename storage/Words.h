// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/detection/Candidates.h"
#include "core/labels/LabelSet.h"
#include "core/planning/Waypoints.h"
#include "core/registration/Registration.h"
#include "core/robot/Visit.h"

namespace fodscope {

// The words for enumerators in a session file. They are part of the file format and never change, unlike the words
// that are shown to people.

std::string wordOf(RegistrationQuality quality);
std::string wordOf(WaypointStatus status);
std::string wordOf(VisitState state);
std::string wordOf(VisitReason reason);
std::string wordOf(LabelKind kind);

// Each throws std::invalid_argument for a word that is none of these.

RegistrationQuality qualityOf(const std::string& word);
WaypointStatus waypointStatusOf(const std::string& word);
VisitState visitStateOf(const std::string& word);
VisitReason visitReasonOf(const std::string& word);
LabelKind labelKindOf(const std::string& word);

}  // namespace fodscope
