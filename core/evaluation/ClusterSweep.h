// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/common/Progress.h"
#include "core/evaluation/ParameterSearch.h"

namespace fodscope {

/// What a trial costs at one threshold, for every cutoff and every least count (which changes fastest).
/// @param voxels those above the threshold, ascending
/// @param cutoffs_m ascending
/// @param leastPoints ascending
std::vector<SearchCost> sweepClusters(const SearchTrial& trial, std::span<const std::uint32_t> voxels,
                                      const ParameterSearchSettings& settings, std::span<const double> cutoffs_m,
                                      std::span<const int> leastPoints, Progress& progress);

/// What a trial costs where there are no candidates.
SearchCost costWithoutCandidates();

}  // namespace fodscope
