// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include "ui/plan/PlanGeometry.h"

namespace fodscope {

/// What the plan says of the thing under the pointer, or of the cell when there is none; empty outside the grid.
QString planToolTip(const PlanScene& scene, const PlanHit& hit, const Eigen::Vector2d& point_map);

/// @return why a candidate has no waypoint, in a sentence's words, e.g. "the robot cannot get near it"
QString reasonInWords(const std::string& waypointStatus);

}  // namespace fodscope
