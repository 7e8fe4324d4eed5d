// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/evaluation/ParameterSearch.h"

namespace fodscope {

/// Every grid point as a row: cluster_cutoff_m, threshold, least_points, cost, distance_m, unassociated_candidates,
/// candidates.
std::string costSurfaceCsv(const ParameterSearchResult& result);

/// A picture (PNG) of the cost over threshold (to the right) and cutoff (upwards) at the best least points, the best
/// point marked. Colours follow the logarithm of the cost; those above the 90th percentile have the last one.
std::vector<std::byte> costSurfacePng(const ParameterSearchResult& result);

}  // namespace fodscope
