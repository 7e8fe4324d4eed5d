// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/evaluation/ParameterSearch.h"
#include "core/evaluation/TrialSelection.h"
#include "core/inspection/Parameters.h"
#include "core/reference/ReferenceMap.h"

namespace fodscope {

/// Trials brought as far as the discrepancy, ready to be searched.
struct MeasuredTrials {
    /// Those with FOD, in the given order.
    std::vector<SearchTrial> trials;
    /// Names of the maps without FOD, which are left out.
    std::vector<std::string> nominalMaps;
    /// Of the maps that could not be aligned: name and why.
    std::map<std::string, std::string> failures;
    /// Per stage, summed over the trials. Several are measured at once, so this is more than the time that passed.
    std::map<std::string, double> stageSeconds;
};

/// Reads and measures the maps of all trials that have FOD, several at once.
/// @throws Error when no trial has FOD, naming those whose stored transform is missing, or the map that cannot be read;
///         Cancelled
MeasuredTrials measureTrials(const std::shared_ptr<const ReferenceMap>& reference, std::span<const Trial> trials,
                             const Parameters& parameters, TrialPlacement placement, Progress& progress);

}  // namespace fodscope
