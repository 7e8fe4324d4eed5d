// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/evaluation/Wilcoxon.h"

namespace fodscope {

/// What a comparison needs of an `evaluation.json`.
struct RecordedFod {
    std::string type;
    /// Empty without candidates.
    std::optional<double> distance_m;
};

struct RecordedTrial {
    std::string name;
    std::vector<RecordedFod> fods;
    /// Empty where the trial failed.
    std::optional<double> unassociatedPoints;
    std::optional<double> unassociatedCandidates;
};

struct RecordedEvaluation {
    std::string file;
    /// By name.
    std::vector<RecordedTrial> trials;
};

/// @throws Error when the file is no evaluation, naming the field, or names a trial twice
RecordedEvaluation readEvaluation(const std::filesystem::path& file);

/// One quantity in two evaluations, paired.
struct PairedTest {
    /// "unassociated_points", "unassociated_candidates" or "distance_error_m".
    std::string quantity;
    std::optional<double> meanA;
    std::optional<double> meanB;
    /// Of A − B: `less` is the p-value for "A smaller than B", `greater` for "B smaller than A".
    WilcoxonResult test;
};

struct Comparison {
    std::string fileA;
    std::string fileB;
    std::size_t trials = 0;
    std::size_t fods = 0;
    /// Failed in A or in B: in no pair of counts.
    std::vector<std::string> failedTrials;
    std::vector<PairedTest> tests;
};

/// Pairs trials by name and FOD by their place in the trial. A FOD without a candidate is charged 7.5 m.
/// @throws Error when the two do not evaluate the same trials with the same FOD; what differs is named
Comparison compareEvaluations(const RecordedEvaluation& a, const RecordedEvaluation& b);

/// Equal comparisons give an equal text.
std::string comparisonJson(const Comparison& comparison);
std::string comparisonText(const Comparison& comparison);

}  // namespace fodscope
