// SPDX-License-Identifier: MIT
#include "ui/tuning/TuningSearch.h"

namespace fodscope {
TuningOutcome runTuning(const TuningRequest& request, Progress& progress) {
    TuningOutcome outcome;
    outcome.measured = request.measured;
    Parameters measuring = request.parameters;
    // The local statistical test is made only where it is asked for.
    if (request.search.metric == Metric::ChiSquare)
        measuring.candidates = usualCandidateSettings(Metric::ChiSquare, measuring);
    if (!outcome.measured)
        outcome.measured = std::make_shared<const MeasuredTrials>(measureTrials(
            request.reference, readTrials(request.folder), measuring, TrialPlacement::Registered, progress));
    outcome.inEffect = request.parameters.candidates;
    outcome.costInEffect = costOf(outcome.measured->trials, outcome.inEffect, request.search.lambda_m, progress);
    outcome.result = searchParameters(outcome.measured->trials, request.search, progress);
    return outcome;
}

SearchCost costOf(std::span<const SearchTrial> trials, const CandidateSettings& settings, double lambda_m,
                  Progress& progress) {
    ParameterSearchSettings one = gridOf(settings);
    one.lambda_m = lambda_m;
    return searchParameters(trials, one, progress).at({0, 0, 0});
}

ParameterSearchSettings gridOf(const CandidateSettings& settings) {
    ParameterSearchSettings one;
    one.metric = settings.metric;
    one.linkage = settings.linkage;
    one.centroid = settings.centroid;
    one.lowestCutoff_m = one.highestCutoff_m = settings.clusterCutoff_m;
    one.cutoffCount = 1;
    one.lowestThreshold = one.highestThreshold = settings.threshold;
    one.thresholdCount = 1;
    one.lowestLeastPoints = one.highestLeastPoints = settings.minimumPoints;
    return one;
}

CostGrid costGridOf(const ParameterSearchResult& result, std::size_t leastPoints) {
    CostGrid grid;
    grid.cutoffs_m = result.cutoffs_m;
    grid.thresholds = result.thresholds;
    grid.cost_m.resize(grid.cutoffs_m.size() * grid.thresholds.size());
    for (std::size_t cutoff = 0; cutoff < grid.cutoffs_m.size(); ++cutoff)
        for (std::size_t threshold = 0; threshold < grid.thresholds.size(); ++threshold)
            grid.cost_m[grid.index(cutoff, threshold)] = result.at({cutoff, threshold, leastPoints}).cost;
    return grid;
}

CostRange costRangeOf(const ParameterSearchResult& result) {
    CostGrid all;
    all.cost_m.reserve(result.costs.size());
    for (const SearchCost& cost : result.costs)
        all.cost_m.push_back(cost.cost);
    return costRange(all);
}

CandidateSettings settingsAt(const ParameterSearchResult& result, const GridPoint& point) {
    ParameterSearchResult chosen;
    chosen.settings = result.settings;
    chosen.cutoffs_m = result.cutoffs_m;
    chosen.thresholds = result.thresholds;
    chosen.leastPoints = result.leastPoints;
    chosen.best = point;
    return bestCandidateSettings(chosen);
}

}  // namespace fodscope
