// SPDX-License-Identifier: MIT
#pragma once

#include "core/inspection/InspectionState.h"

namespace fodscope {

struct TankOptions {
    int candidates = 8;
    /// False: only the map was detected on; no plan, visits, photos or decisions.
    bool visited = true;
    /// False: photos wait for their decisions.
    bool decided = true;
};

/// An inspection of an imaginary tank of 3.2 × 2.6 m as it is after two readers labelled: findings, one candidate
/// rejected, one that the readers disagree on, one not sure, one out of the robot's reach. The map frame is turned and
/// shifted against the reference's, and photos are drawn where the pinhole puts things, so that mixing up frames shows.
/// The same options give the same inspection to the byte.
InspectionState tankInspection(const TankOptions& options = {});

}  // namespace fodscope
