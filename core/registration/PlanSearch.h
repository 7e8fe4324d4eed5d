// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/common/Geometry.h"
#include "core/common/Progress.h"
#include "core/registration/SurfacePatches.h"

namespace fodscope {

/// Poses at which the upright surfaces of the map lie on those of the reference, for any yaw and place. Both are
/// levelled by their floors; then the plan of the walls is turned in steps and correlated with the reference's plan at
/// all shifts at once (FFT), where a wall counts for walls of its direction and against those across it. The height
/// comes from the level surfaces. Deterministic.
/// @return motions T_reference_from_map that differ, the best correlated first, `count` at most; empty when either has
/// no upright surfaces
std::vector<Transform> searchPlan(const SurfacePatches& map, const SurfacePatches& reference, std::size_t count,
                                  Progress& progress);

/// The rotation that makes the level surfaces of a cloud level, whose z axis leans by some degrees at most.
Eigen::Matrix3d levelling(const SurfacePatches& cloud);

}  // namespace fodscope
