// SPDX-License-Identifier: MIT
#include "core/evaluation/Summary.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace fodscope {
namespace {

constexpr double kNear_m = 0.15;
constexpr double kFar_m = 0.30;

std::optional<double> ratio(std::size_t part, std::size_t whole) {
    if (whole == 0) return std::nullopt;
    return static_cast<double>(part) / static_cast<double>(whole);
}

void count(Recall& recall, const EvaluatedFod& fod) {
    ++recall.fods;
    if (!fod.distance_m) return;
    if (*fod.distance_m <= kNear_m) ++recall.within15cm;
    if (*fod.distance_m <= kFar_m) ++recall.within30cm;
}

MeanAndDeviation overCountedTrials(std::span<const EvaluatedTrial> trials, std::size_t TrialCounts::*member) {
    std::vector<double> values;
    for (const EvaluatedTrial& trial : trials)
        if (trial.counts) values.push_back(static_cast<double>((*trial.counts).*member));
    return meanAndDeviation(values);
}

void summarizeFods(std::span<const EvaluatedTrial> trials, EvaluationSummary& summary) {
    std::vector<double> distances_m;
    std::map<std::string, TypeRecall> types;
    for (const EvaluatedTrial& trial : trials) {
        for (const EvaluatedFod& fod : trial.fods) {
            count(summary.recall, fod);
            if (fod.observed) count(summary.recallObserved, fod);
            TypeRecall& type = types[fod.type];
            type.type = fod.type;
            count(type.recall, fod);
            if (fod.photographed.value_or(false)) ++type.photographed;
            distances_m.push_back(fod.distance_m.value_or(kNoCandidateDistance_m));
            if (!fod.distance_m) ++summary.chargedFods;
        }
    }
    summary.fods = distances_m.size();
    summary.distanceError_m = meanAndDeviation(distances_m);
    for (const auto& [name, type] : types)
        summary.recallByType.push_back(type);
}

void summarizePhotos(std::span<const EvaluatedTrial> trials, EvaluationSummary& summary) {
    PhotoSummary photos;
    bool taken = false;
    for (const EvaluatedTrial& trial : trials) {
        photos.fods += trial.fods.size();
        if (!trial.photos) continue;
        taken = true;
        photos.photos += trial.photos->photos;
        photos.photosWithFod += trial.photos->photosWithFod;
        photos.candidatesWithoutPhoto += trial.photos->candidatesWithoutPhoto;
        photos.candidatesInPart += trial.photos->candidatesInPart;
        for (const auto& [reason, count] : trial.photos->reasons)
            photos.reasons[reason] += count;
        photos.drive_m += trial.photos->drive_m;
        photos.nearestNext_m += trial.photos->nearestNext_m;
        photos.fodsPhotographed += static_cast<std::size_t>(std::ranges::count(trial.photos->isPhotographed, 1));
    }
    if (taken) summary.photos = photos;
}

}  // namespace

std::optional<double> PhotoSummary::precision() const {
    return ratio(photosWithFod, photos);
}

std::optional<double> PhotoSummary::recall() const {
    return ratio(fodsPhotographed, fods);
}

std::optional<double> PhotoSummary::photosPerFod() const {
    return ratio(photos, fods);
}

MeanAndDeviation meanAndDeviation(std::span<const double> values) {
    MeanAndDeviation result;
    result.count = values.size();
    if (values.empty()) return result;
    const auto count = static_cast<double>(values.size());
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    const double mean = sum / count;
    result.mean = mean;
    if (values.size() < 2) return result;
    double squares = 0.0;
    for (const double value : values)
        squares += (value - mean) * (value - mean);
    result.deviation = std::sqrt(squares / (count - 1.0));
    return result;
}

EvaluationSummary summarize(std::span<const EvaluatedTrial> trials) {
    EvaluationSummary summary;
    std::vector<double> costs;
    for (const EvaluatedTrial& trial : trials) {
        costs.push_back(trial.cost);
        if (trial.counts)
            summary.totalCandidates += trial.counts->candidates;
        else
            summary.failedTrials.push_back(trial.name);
    }
    summary.meanCost = meanAndDeviation(costs).mean;
    summary.unassociatedPoints = overCountedTrials(trials, &TrialCounts::unassociatedPoints);
    summary.unassociatedCandidates = overCountedTrials(trials, &TrialCounts::unassociatedCandidates);
    summary.falseCandidates = overCountedTrials(trials, &TrialCounts::falseCandidates);
    summarizeFods(trials, summary);
    summarizePhotos(trials, summary);
    return summary;
}

}  // namespace fodscope
