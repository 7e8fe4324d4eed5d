// SPDX-License-Identifier: MIT
#pragma once

#include "core/detection/Candidates.h"

namespace fodscope {

/// Carries ids over from an earlier clustering of the same field: a cluster keeps the id of the earlier one with which
/// it shares most voxels (ties: the lower id), an unmatched one gets a number above `highestUsed`, and none is used
/// twice.
/// @param highestUsed the highest number ever given in this inspection; raised as new ones are given
void carryOverIds(const CandidateSet& earlier, CandidateSet& later, int& highestUsed);

}  // namespace fodscope
