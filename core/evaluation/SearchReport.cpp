// SPDX-License-Identifier: MIT
#include "core/evaluation/SearchReport.h"

#include <cstdio>

#include "core/inspection/ParameterTable.h"

namespace fodscope {
namespace {

std::string number(double value, int digits = 4) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

std::string fixed(double value, int decimals) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

std::string unitOf(Metric metric) {
    return metric == Metric::Euclidean ? " m" : "";
}

std::string choiceIn(const std::string& key, const CandidateSettings& settings) {
    Parameters parameters;
    parameters.candidates = settings;
    return toString(findParameter("candidates", key)->get(parameters));
}

/// A best point at the border of the grid may have a better one beyond it.
std::vector<std::string> borders(const ParameterSearchResult& result) {
    std::vector<std::string> names;
    const auto look = [&](std::size_t index, std::size_t count, bool lowIsBorder, const char* name) {
        if (count > 1 && (index + 1 == count || (index == 0 && lowIsBorder))) names.emplace_back(name);
    };
    look(result.best.cutoff, result.cutoffs_m.size(), true, "cluster cutoff");
    look(result.best.threshold, result.thresholds.size(), true, "threshold");
    // There is nothing below no least points at all.
    look(result.best.leastPoints, result.leastPoints.size(), result.leastPoints.front() > 1, "least points");
    return names;
}

}  // namespace

std::string nameOf(Metric metric) {
    CandidateSettings settings;
    settings.metric = metric;
    return choiceIn("metric", settings);
}

std::string nameOf(Linkage linkage) {
    CandidateSettings settings;
    settings.linkage = linkage;
    return choiceIn("linkage", settings);
}

std::vector<std::string> searchFindings(const ParameterSearchResult& result) {
    const CandidateSettings best = bestCandidateSettings(result);
    const SearchCost& cost = result.at(result.best);
    std::vector<std::string> lines;
    lines.push_back("Best of " + std::to_string(result.costs.size()) + " grid points over " +
                    std::to_string(result.trialCount) + " trials with " + std::to_string(result.fodCount) +
                    " FOD: threshold " + fixed(best.threshold, 4) + unitOf(best.metric) + ", cluster cutoff " +
                    fixed(best.clusterCutoff_m, 3) + " m, least points " + std::to_string(best.minimumPoints) + " (" +
                    nameOf(best.metric) + ", " + nameOf(best.linkage) + " linkage).");
    lines.push_back("Mean cost " + fixed(cost.cost, 4) + " m per trial: its FOD lie " + fixed(cost.distance_m, 3) +
                    " m from their nearest candidates, and " + fixed(cost.unassociatedCandidates, 2) + " of " +
                    fixed(cost.candidates, 2) + " candidates are no FOD's nearest one, " +
                    number(result.settings.lambda_m) + " m each.");
    for (const std::string& border : borders(result))
        lines.push_back("The best " + border + " is the last one on the grid: a wider grid may hold a better one.");
    return lines;
}

std::vector<std::string> searchMethod(const ParameterSearchResult& result) {
    const ParameterSearchSettings& settings = result.settings;
    std::vector<std::string> lines;
    lines.push_back("Grid: " + std::to_string(result.cutoffs_m.size()) + " cluster cutoffs from " +
                    number(result.cutoffs_m.front()) + " to " + number(result.cutoffs_m.back()) + " m, " +
                    std::to_string(result.thresholds.size()) + " thresholds from " +
                    number(result.thresholds.front(), 6) + " to " + number(result.thresholds.back(), 6) +
                    unitOf(settings.metric) + ", least points " + std::to_string(result.leastPoints.front()) + " to " +
                    std::to_string(result.leastPoints.back()) + ".");
    if (!settings.lowestThreshold) {
        lines.push_back("The lowest threshold is the least, over the trials, of the percentile " +
                        number(settings.lowestThresholdPercentile) + " of the discrepancies.");
    }
    lines.push_back(
        "Cost of a trial: mean distance from a FOD to its nearest candidate + lambda x candidates that are "
        "no FOD's nearest one;");
    lines.push_back("lambda " + number(settings.lambda_m) + " m; a FOD in a trial without candidates counts " +
                    number(kNoCandidateDistance_m) + " m. Ties go to the lower cutoff, threshold, least points.");
    lines.push_back("Metric " + nameOf(settings.metric) + ", " + nameOf(settings.linkage) +
                    " linkage; all other parameters as below.");
    return lines;
}

}  // namespace fodscope
