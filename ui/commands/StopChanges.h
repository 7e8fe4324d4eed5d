// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include "ui/session/InspectionController.h"

namespace fodscope {

/// @return the index of a waypoint among the plan's stops; empty for one without a pose, or none
std::optional<std::size_t> stopIndex(const InspectionController& controller, const QString& waypointId);

/// Takes a waypoint out of the plan.
void removeStop(InspectionController& controller, const QString& waypointId);

/// Visits a waypoint earlier (−1) or later (+1).
void shiftStop(InspectionController& controller, const QString& waypointId, int step);

}  // namespace fodscope
