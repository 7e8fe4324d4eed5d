// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/simulation/DepthMapping.h"

namespace fodscope {

/// What a SLAM believes of a drive: every pose moved by an error that wanders (Ornstein-Uhlenbeck along the way).
/// @param poses_world true camera body poses, in order
std::vector<Transform> withDrift(const std::vector<Transform>& poses_world, const DepthMappingSettings& settings);

}  // namespace fodscope
