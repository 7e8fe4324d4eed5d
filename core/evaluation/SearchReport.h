// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/evaluation/ParameterSearch.h"

namespace fodscope {

/// The best values and what they cost, in words, a line each.
std::vector<std::string> searchFindings(const ParameterSearchResult& result);

/// Where the values come from, in words: the grid, what was fixed, the cost function. A line each, for the head of a
/// parameter file.
std::vector<std::string> searchMethod(const ParameterSearchResult& result);

/// "euclidean", "mahalanobis", …, as in a parameter file.
std::string nameOf(Metric metric);
std::string nameOf(Linkage linkage);

}  // namespace fodscope
