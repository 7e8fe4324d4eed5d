// SPDX-License-Identifier: MIT
#include "core/evaluation/ParameterSearch.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/common/Error.h"
#include "core/evaluation/ClusterSweep.h"
#include "core/evaluation/Numpy.h"
#include "core/evaluation/SharedProgress.h"

namespace fodscope {
namespace {

constexpr int kMostOnAnAxis = 1000;
constexpr std::size_t kMostGridPoints = 10'000'000;

/// One trial at one threshold.
struct Task {
    std::size_t trial = 0;
    std::size_t threshold = 0;
    std::vector<std::uint32_t> voxels;
};

void require(std::span<const SearchTrial> trials, const ParameterSearchSettings& settings) {
    std::string problems;
    for (const std::string& problem : parameterSearchProblems(settings))
        problems += (problems.empty() ? "" : ", ") + problem;
    if (!problems.empty()) throw Error("parameter search", problems, "mend its settings");
    if (trials.empty()) throw Error("parameter search", "has no trials", "give maps with known FOD");
    for (const SearchTrial& trial : trials) {
        if (trial.fods_map.empty())
            throw Error(trial.name, "is a map without FOD, which costs nothing", "leave nominal maps out");
        if (!std::ranges::all_of(trial.fods_map, [](const Eigen::Vector3d& fod) { return fod.allFinite(); }))
            throw Error(trial.name, "a FOD's centroid is not finite", "mend its ground truth");
    }
}

std::vector<double> thresholdsOf(std::span<const SearchTrial> trials, const ParameterSearchSettings& settings) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const SearchTrial& trial : trials) {
        if (!trial.field) continue;
        const auto percentile =
            percentileOfKnown(trial.field->smoothed(settings.metric), settings.lowestThresholdPercentile);
        if (percentile) lowest = std::min(lowest, *percentile);
    }
    if (!std::isfinite(lowest)) {
        throw Error("trials", "no map could be aligned and compared, so there is nothing to search in",
                    "check that trials and reference show the same space");
    }
    lowest = settings.lowestThreshold.value_or(lowest);
    const double highest = settings.highestThreshold.value_or(usualHighestThreshold(settings.metric));
    if (lowest > highest) {
        throw Error(
            "thresholds",
            "the lowest, " + std::to_string(lowest) + ", is greater than the highest, " + std::to_string(highest),
            "give a greater highest threshold");
    }
    return linearSpace(lowest, highest, settings.thresholdCount);
}

/// Largest first, so that the last ones to end are short.
std::vector<Task> tasksOf(std::span<const SearchTrial> trials, Metric metric, std::span<const double> thresholds) {
    std::vector<Task> tasks;
    for (std::size_t t = 0; t < trials.size(); ++t) {
        if (!trials[t].field) continue;
        const std::vector<double>& discrepancy = trials[t].field->smoothed(metric);
        for (std::size_t h = 0; h < thresholds.size(); ++h) {
            Task& task = tasks.emplace_back(Task{t, h, {}});
            for (std::size_t i = 0; i < discrepancy.size(); ++i)
                if (discrepancy[i] > thresholds[h]) task.voxels.push_back(static_cast<std::uint32_t>(i));
        }
    }
    std::ranges::stable_sort(tasks, std::greater<>(), [](const Task& task) { return task.voxels.size(); });
    return tasks;
}

/// Costs per task, in the tasks' order.
std::vector<std::vector<SearchCost>> sweepAll(std::span<const SearchTrial> trials, std::span<const Task> tasks,
                                              const ParameterSearchResult& grid, Progress& progress) {
    const auto workOf = [](const Task& task) { return static_cast<double>(task.voxels.size() + 1); };
    double work = 0.0;
    for (const Task& task : tasks)
        work += workOf(task);
    SharedProgress shared(progress, "searching the parameters", work);
    std::vector<std::vector<SearchCost>> costs(tasks.size());
    std::atomic<std::size_t> next{0};
    // The index is not used: each call takes the largest task that is left.
    tbb::parallel_for(
        std::size_t{0}, tasks.size(),
        [&](std::size_t) {
            const std::size_t taken = next++;
            const Task& task = tasks[taken];
            Progress part = shared.forPart();
            costs[taken] =
                sweepClusters(trials[task.trial], task.voxels, grid.settings, grid.cutoffs_m, grid.leastPoints, part);
            shared.add(workOf(task));
        },
        tbb::simple_partitioner());
    return costs;
}

/// Means over the trials, summed in their order.
void average(std::span<const SearchTrial> trials, std::span<const Task> tasks,
             std::span<const std::vector<SearchCost>> taskCosts, ParameterSearchResult& result) {
    const std::size_t thresholds = result.thresholds.size();
    const std::size_t levels = result.leastPoints.size();
    std::vector<const std::vector<SearchCost>*> costsAt(trials.size() * thresholds, nullptr);
    for (std::size_t i = 0; i < tasks.size(); ++i)
        costsAt[tasks[i].trial * thresholds + tasks[i].threshold] = &taskCosts[i];
    result.costs.assign(result.cutoffs_m.size() * thresholds * levels, {});
    for (std::size_t t = 0; t < trials.size(); ++t) {
        for (std::size_t i = 0; i < result.costs.size(); ++i) {
            const std::size_t cutoff = i / (thresholds * levels);
            const std::size_t threshold = i / levels % thresholds;
            const auto* costs = costsAt[t * thresholds + threshold];
            const SearchCost cost = costs ? (*costs)[cutoff * levels + i % levels] : costWithoutCandidates();
            result.costs[i].cost += cost.cost;
            result.costs[i].distance_m += cost.distance_m;
            result.costs[i].unassociatedCandidates += cost.unassociatedCandidates;
            result.costs[i].candidates += cost.candidates;
        }
    }
    const auto count = static_cast<double>(trials.size());
    for (SearchCost& cost : result.costs)
        cost = {cost.cost / count, cost.distance_m / count, cost.unassociatedCandidates / count,
                cost.candidates / count};
}

GridPoint bestOf(const ParameterSearchResult& result) {
    const auto best = std::ranges::min_element(result.costs, {}, &SearchCost::cost);
    const auto index = static_cast<std::size_t>(best - result.costs.begin());
    const std::size_t levels = result.leastPoints.size();
    const std::size_t thresholds = result.thresholds.size();
    return {index / (thresholds * levels), index / levels % thresholds, index % levels};
}

double secondsSince(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

double usualHighestThreshold(Metric metric) {
    switch (metric) {
        case Metric::Euclidean:
            return 0.05;
        case Metric::Mahalanobis:
            return 3.0;
        case Metric::ChiSquare:
            return 3000.0;
    }
    return 3.0;
}

std::vector<std::string> parameterSearchProblems(const ParameterSearchSettings& settings) {
    std::vector<std::string> problems;
    const auto check = [&](bool isGood, const std::string& problem) {
        if (!isGood) problems.push_back(problem);
    };
    const auto isNumber = [](double value) { return value >= 0.0 && std::isfinite(value); };
    const auto isCount = [](int count) { return count >= 1 && count <= kMostOnAnAxis; };
    check(isNumber(settings.lowestCutoff_m) && isNumber(settings.highestCutoff_m),
          "the cutoffs must be lengths of at least 0 m");
    check(!(settings.lowestCutoff_m > settings.highestCutoff_m), "the lowest cutoff is greater than the highest");
    check(isCount(settings.cutoffCount), "the number of cutoffs must be 1 to 1000");
    check(!settings.lowestThreshold || isNumber(*settings.lowestThreshold),
          "the lowest threshold must be a number of at least 0");
    check(!settings.highestThreshold || isNumber(*settings.highestThreshold),
          "the highest threshold must be a number of at least 0");
    check(!settings.lowestThreshold || !settings.highestThreshold ||
              !(*settings.lowestThreshold > *settings.highestThreshold),
          "the lowest threshold is greater than the highest");
    check(settings.lowestThresholdPercentile >= 0.0 && settings.lowestThresholdPercentile <= 100.0,
          "the percentile of the lowest threshold must be 0 to 100");
    check(isCount(settings.thresholdCount), "the number of thresholds must be 1 to 1000");
    check(settings.lowestLeastPoints >= 0 && settings.highestLeastPoints >= settings.lowestLeastPoints &&
              settings.highestLeastPoints - settings.lowestLeastPoints < kMostOnAnAxis,
          "the least points must ascend from 0 or more, at most 1000 of them");
    check(isNumber(settings.lambda_m), "lambda must be a number of at least 0");
    if (problems.empty()) {
        const std::size_t points =
            static_cast<std::size_t>(settings.cutoffCount) * static_cast<std::size_t>(settings.thresholdCount) *
            static_cast<std::size_t>(settings.highestLeastPoints - settings.lowestLeastPoints + 1);
        check(points <= kMostGridPoints, "the grid must have at most 10 million points");
    }
    return problems;
}

const SearchCost& ParameterSearchResult::at(const GridPoint& point) const {
    return costs.at((point.cutoff * thresholds.size() + point.threshold) * leastPoints.size() + point.leastPoints);
}

ParameterSearchResult searchParameters(std::span<const SearchTrial> trials, const ParameterSearchSettings& settings,
                                       Progress& progress) {
    require(trials, settings);
    auto begin = std::chrono::steady_clock::now();
    progress.report("thresholds", 0.0);
    ParameterSearchResult result;
    result.settings = settings;
    result.trialCount = trials.size();
    for (const SearchTrial& trial : trials)
        result.fodCount += trial.fods_map.size();
    result.cutoffs_m = linearSpace(settings.lowestCutoff_m, settings.highestCutoff_m, settings.cutoffCount);
    result.thresholds = thresholdsOf(trials, settings);
    for (int least = settings.lowestLeastPoints; least <= settings.highestLeastPoints; ++least)
        result.leastPoints.push_back(least);
    const std::vector<Task> tasks = tasksOf(trials, settings.metric, result.thresholds);
    result.stageSeconds["thresholds"] = secondsSince(begin);
    begin = std::chrono::steady_clock::now();
    average(trials, tasks, sweepAll(trials, tasks, result, progress), result);
    result.best = bestOf(result);
    result.stageSeconds["clusters"] = secondsSince(begin);
    return result;
}

CandidateSettings bestCandidateSettings(const ParameterSearchResult& result) {
    CandidateSettings settings;
    settings.metric = result.settings.metric;
    settings.linkage = result.settings.linkage;
    settings.centroid = result.settings.centroid;
    settings.clusterCutoff_m = result.cutoffs_m.at(result.best.cutoff);
    settings.threshold = result.thresholds.at(result.best.threshold);
    settings.minimumPoints = result.leastPoints.at(result.best.leastPoints);
    return settings;
}

}  // namespace fodscope
