// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/evaluation/SearchTrials.h"
#include "ui/tuning/CostGrid.h"

namespace fodscope {

struct TuningRequest {
    std::filesystem::path folder;
    std::shared_ptr<const ReferenceMap> reference;
    /// Those in effect: they say how the trials are brought to candidates, and what the search is compared with.
    Parameters parameters;
    ParameterSearchSettings search;
    /// From an earlier search with the same folder, reference and detection settings; null: made anew.
    std::shared_ptr<const MeasuredTrials> measured;
};

struct TuningOutcome {
    std::shared_ptr<const MeasuredTrials> measured;
    ParameterSearchResult result;
    /// What the settings in effect cost in the same trials, whatever their metric.
    CandidateSettings inEffect;
    SearchCost costInEffect;
};

/// Prepares the trials where that is needed, searches, and costs the settings in effect. For a worker thread.
/// @throws Error; Cancelled
TuningOutcome runTuning(const TuningRequest& request, Progress& progress);

/// @return what candidates with these settings cost in the trials
SearchCost costOf(std::span<const SearchTrial> trials, const CandidateSettings& settings, double lambda_m,
                  Progress& progress);

/// @return a grid of this one setting, as a search takes it
ParameterSearchSettings gridOf(const CandidateSettings& settings);

/// The part of a result at one count of least points.
CostGrid costGridOf(const ParameterSearchResult& result, std::size_t leastPoints);
/// Over all least points, so that colours keep their meaning from one to the next.
CostRange costRangeOf(const ParameterSearchResult& result);

/// Settings with the values of a grid point.
CandidateSettings settingsAt(const ParameterSearchResult& result, const GridPoint& point);

}  // namespace fodscope
