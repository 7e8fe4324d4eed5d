// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fodscope {

/// One of the sets to choose from: what it covers, ascending, and what it costs.
struct CoverSet {
    std::vector<std::size_t> elements;
    double cost = 0.0;
};

/// Chooses the fewest sets that cover every element which any set covers, and of equally few ones the cheapest. Exact
/// for what a tank brings; where the search grows beyond bounds, the best that was found until then, never worse than
/// the greedy choice. Equal input gives an equal choice.
/// @return indices of the chosen sets, ascending
std::vector<std::size_t> fewestSets(std::span<const CoverSet> sets, std::size_t elementCount);

}  // namespace fodscope
