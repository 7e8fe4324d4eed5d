// SPDX-License-Identifier: MIT
#include "app/cli/GridOptions.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <optional>
#include <sstream>
#include <vector>

#include "app/cli/Context.h"

namespace fodscope::cli {
namespace {

template <typename Number>
std::optional<Number> numberIn(const std::string& word) {
    Number number{};
    const auto end = std::from_chars(word.data(), word.data() + word.size(), number);
    if (end.ec != std::errc() || end.ptr != word.data() + word.size()) return std::nullopt;
    return number;
}

std::vector<std::string> wordsOf(const std::string& text) {
    std::vector<std::string> words;
    std::istringstream stream(text);
    for (std::string word; std::getline(stream, word, ',');)
        words.push_back(word);
    return words;
}

struct Axis {
    /// Empty: "auto".
    std::optional<double> lowest;
    double highest = 0.0;
    int count = 0;
};

Axis axisOf(const std::string& option, const std::string& text, bool mayBeAuto) {
    const std::vector<std::string> words = wordsOf(text);
    const bool isAuto = mayBeAuto && !words.empty() && words[0] == "auto";
    if (words.size() == 3) {
        const auto lowest = numberIn<double>(words[0]);
        const auto highest = numberIn<double>(words[1]);
        const auto count = numberIn<int>(words[2]);
        if ((lowest || isAuto) && highest && count) return {lowest, *highest, *count};
    }
    throw UsageError(option + ": '" + text + "' is not LOW,HIGH,COUNT" + (mayBeAuto ? " (LOW may be auto)" : ""));
}

}  // namespace

void addGridOptions(CLI::App& command, GridOptions& options) {
    command
        .add_option("--cutoffs", options.cutoffs,
                    "cluster cutoffs on the grid, evenly spaced [m]; without it 0.05,1,30")
        ->type_name("LOW,HIGH,COUNT");
    command
        .add_option("--thresholds", options.thresholds,
                    "thresholds on the grid; LOW may be auto (25th percentile of the discrepancies); without it "
                    "auto,3,20 (euclidean: auto,0.05,20; chi-square: auto,3000,20)")
        ->type_name("LOW,HIGH,COUNT");
    command.add_option("--least-points", options.leastPoints, "least points on the grid; without it 0,9")
        ->type_name("LOW,HIGH");
    command.add_option("--lambda", options.lambda_m, "cost of a candidate that is no FOD's nearest one [m]")
        ->capture_default_str();
}

ParameterSearchSettings searchSettingsOf(const GridOptions& options, const CandidateSettings& method) {
    ParameterSearchSettings settings;
    settings.metric = method.metric;
    settings.linkage = method.linkage;
    settings.centroid = method.centroid;
    return searchSettingsOver(settings, options);
}

ParameterSearchSettings searchSettingsOver(ParameterSearchSettings settings, const GridOptions& options) {
    settings.lambda_m = options.lambda_m;
    if (!options.cutoffs.empty()) {
        const Axis axis = axisOf("--cutoffs", options.cutoffs, false);
        settings.lowestCutoff_m = *axis.lowest;
        settings.highestCutoff_m = axis.highest;
        settings.cutoffCount = axis.count;
    }
    if (!options.thresholds.empty()) {
        const Axis axis = axisOf("--thresholds", options.thresholds, true);
        settings.lowestThreshold = axis.lowest;
        settings.highestThreshold = axis.highest;
        settings.thresholdCount = axis.count;
    }
    if (!options.leastPoints.empty()) {
        const std::vector<std::string> words = wordsOf(options.leastPoints);
        const auto lowest = words.size() == 2 ? numberIn<int>(words[0]) : std::nullopt;
        const auto highest = words.size() == 2 ? numberIn<int>(words[1]) : std::nullopt;
        if (!lowest || !highest) throw UsageError("--least-points: '" + options.leastPoints + "' is not LOW,HIGH");
        settings.lowestLeastPoints = *lowest;
        settings.highestLeastPoints = *highest;
    }
    std::string problems;
    for (const std::string& problem : parameterSearchProblems(settings))
        problems += (problems.empty() ? "" : "; ") + problem;
    if (!problems.empty()) throw UsageError(problems);
    return settings;
}

}  // namespace fodscope::cli
