// SPDX-License-Identifier: MIT
#pragma once

#include "core/planning/Waypoints.h"

namespace fodscope {

/// @throws Error when a setting is out of range
void requireInRange(const WaypointSettings& settings);

/// @throws Error when the two maps differ in lattice, or the first was not flood filled
void requireSameLattice(const CostMap& collision, const CostMap& sight);

/// @return "W-01" for 1
std::string waypointId(std::size_t number);

}  // namespace fodscope
