// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/evaluation/ParameterSearch.h"

namespace CLI {
class App;
}

namespace fodscope::cli {

/// The grid of a parameter search as it is typed; empty is the paper's.
struct GridOptions {
    /// LOW,HIGH,COUNT; the low end of the thresholds may be "auto".
    std::string cutoffs;
    std::string thresholds;
    /// LOW,HIGH
    std::string leastPoints;
    double lambda_m = kUnassociatedWeight_m;
};

/// --cutoffs, --thresholds, --least-points, --lambda
void addGridOptions(CLI::App& command, GridOptions& options);

/// @param method metric, linkage and kind of centroid
/// @throws UsageError for text that is no grid, and for one that means nothing, with all of its problems
ParameterSearchSettings searchSettingsOf(const GridOptions& options, const CandidateSettings& method);

/// The same over another grid than the paper's where an option is not given.
/// @throws UsageError as searchSettingsOf() does
ParameterSearchSettings searchSettingsOver(ParameterSearchSettings settings, const GridOptions& options);

}  // namespace fodscope::cli
