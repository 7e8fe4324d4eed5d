// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/evaluation/Evaluation.h"

namespace fodscope {

/// Mean and sample standard deviation (n − 1): empty where there are too few values.
struct MeanAndDeviation {
    std::size_t count = 0;
    std::optional<double> mean;
    std::optional<double> deviation;
};

MeanAndDeviation meanAndDeviation(std::span<const double> values);

/// Share of FOD with a candidate at most so far away; empty without FOD.
struct Recall {
    std::size_t fods = 0;
    std::size_t within15cm = 0;
    std::size_t within30cm = 0;

    std::optional<double> at15cm() const { return share(within15cm); }
    std::optional<double> at30cm() const { return share(within30cm); }

  private:
    std::optional<double> share(std::size_t found) const {
        if (fods == 0) return std::nullopt;
        return static_cast<double>(found) / static_cast<double>(fods);
    }
};

struct TypeRecall {
    std::string type;
    Recall recall;
    /// FOD of the type that a photo shows.
    std::size_t photographed = 0;
};

/// Over all trials. A FOD counts as photographed when at least one photo shows it.
struct PhotoSummary {
    std::size_t photos = 0;
    std::size_t photosWithFod = 0;
    std::size_t fods = 0;
    std::size_t fodsPhotographed = 0;
    std::size_t candidatesWithoutPhoto = 0;
    std::size_t candidatesInPart = 0;
    std::map<std::string, std::size_t> reasons;
    double drive_m = 0.0;
    double nearestNext_m = 0.0;

    /// Share of photos that show FOD; empty without photos.
    std::optional<double> precision() const;
    /// Share of FOD that a photo shows; empty without FOD.
    std::optional<double> recall() const;
    std::optional<double> photosPerFod() const;
};

/// The paper's figures for a folder of trials. Failed trials are in the recalls, the distance and the cost (their FOD
/// were not found), but in no count of candidates or points, of which nothing is known there.
struct EvaluationSummary {
    std::size_t fods = 0;
    std::vector<std::string> failedTrials;
    std::size_t totalCandidates = 0;
    MeanAndDeviation unassociatedPoints;
    MeanAndDeviation unassociatedCandidates;
    MeanAndDeviation falseCandidates;
    /// Over FOD; one in a trial without candidates is charged 7.5 m.
    MeanAndDeviation distanceError_m;
    /// How many FOD were so charged.
    std::size_t chargedFods = 0;
    Recall recall;
    Recall recallObserved;
    /// By name of the type.
    std::vector<TypeRecall> recallByType;
    /// Over trials.
    std::optional<double> meanCost;
    std::optional<PhotoSummary> photos;
};

EvaluationSummary summarize(std::span<const EvaluatedTrial> trials);

}  // namespace fodscope
