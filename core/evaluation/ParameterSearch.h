// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/common/Geometry.h"
#include "core/common/Progress.h"
#include "core/detection/Candidates.h"
#include "core/detection/Discrepancy.h"
#include "core/evaluation/Association.h"

namespace fodscope {

/// The grid of the paper's parameter search and what a grid point costs. Paper: "Parameter Search".
struct ParameterSearchSettings {
    /// What is not searched for.
    Metric metric = Metric::Mahalanobis;
    Linkage linkage = Linkage::Centroid;
    CentroidKind centroid = CentroidKind::Plain;
    /// Cluster cutoffs, evenly spaced with both ends among them. Paper: 30 from 0.05 to 1 m.
    double lowestCutoff_m = 0.05;
    double highestCutoff_m = 1.0;
    int cutoffCount = 30;
    /// Thresholds, likewise. Paper: 20, the lowest being the least over the trials of the 25th percentile of the
    /// smoothed discrepancies.
    std::optional<double> lowestThreshold;
    double lowestThresholdPercentile = 25.0;
    /// Empty: usualHighestThreshold().
    std::optional<double> highestThreshold;
    int thresholdCount = 20;
    /// Least points of a candidate, all whole numbers. Paper: 0 to 9.
    int lowestLeastPoints = 0;
    int highestLeastPoints = 9;
    /// λ, the cost of a candidate that is no FOD's nearest one. Paper: 0.05.
    double lambda_m = kUnassociatedWeight_m;

    bool operator==(const ParameterSearchSettings&) const = default;
};

/// Paper: 3 for Mahalanobis, 0.05 m for Euclidean. It has none for chi-square; 3000 there, since by the test's
/// definition each voxel beyond 3 σ among the 16 that are looked at adds 250, and the distance ends at 3162.
double usualHighestThreshold(Metric metric);

/// @return what is wrong with the settings as a whole, one sentence each
std::vector<std::string> parameterSearchProblems(const ParameterSearchSettings& settings);

/// A map with known FOD, brought as far as the discrepancy.
struct SearchTrial {
    std::string name;
    /// Null when the map could not be aligned: it has no candidates then, whatever the parameters.
    std::shared_ptr<const DiscrepancyField> field;
    Transform T_reference_from_map = Transform::Identity();
    /// Centroids of the FOD, map frame; at least one.
    std::vector<Eigen::Vector3d> fods_map;
};

/// Means over the trials at a grid point.
struct SearchCost {
    /// Distance + λ · unassociated candidates, see associate().
    double cost = 0.0;
    /// Mean distance from a FOD to its nearest candidate; 7.5 m in a trial without candidates.
    double distance_m = 0.0;
    double unassociatedCandidates = 0.0;
    double candidates = 0.0;

    bool operator==(const SearchCost&) const = default;
};

/// Indices into the three axes of the grid.
struct GridPoint {
    std::size_t cutoff = 0;
    std::size_t threshold = 0;
    std::size_t leastPoints = 0;

    bool operator==(const GridPoint&) const = default;
};

struct ParameterSearchResult {
    ParameterSearchSettings settings;
    std::size_t trialCount = 0;
    std::size_t fodCount = 0;
    std::vector<double> cutoffs_m;
    std::vector<double> thresholds;
    std::vector<int> leastPoints;
    /// Every grid point: the least points change fastest, then the threshold, then the cutoff.
    std::vector<SearchCost> costs;
    /// The lowest cost; a tie goes to the lower cutoff, then the lower threshold, then the fewer points.
    GridPoint best;
    /// Wall time of "thresholds" and "clusters".
    std::map<std::string, double> stageSeconds;

    const SearchCost& at(const GridPoint& point) const;
};

/// Runs thresholding, clustering and association at every grid point: the same candidates as findCandidates() makes,
/// the same cost as associate() gives. The merges of the largest cutoff hold the clusters of all smaller ones, and the
/// least points only leave clusters out, so each trial is clustered once for each threshold. Parallel; the result does
/// not depend on the number of threads. Only the calling thread reports its progress.
/// @throws Error for settings that parameterSearchProblems() names, all at once, for no trials, trials without FOD or a
///         discrepancy that is unknown everywhere, and thresholds whose automatic lower end is beyond the upper;
///         Cancelled
ParameterSearchResult searchParameters(std::span<const SearchTrial> trials, const ParameterSearchSettings& settings,
                                       Progress& progress);

/// @return candidate settings with the best point's values
CandidateSettings bestCandidateSettings(const ParameterSearchResult& result);

}  // namespace fodscope
