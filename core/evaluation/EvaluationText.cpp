// SPDX-License-Identifier: MIT
#include "core/evaluation/EvaluationReport.h"
#include "core/evaluation/Summary.h"
#include "core/evaluation/TextTable.h"
#include "core/inspection/ParameterTable.h"
#include "core/inspection/ReportText.h"

namespace fodscope {
namespace {

using Rows = std::vector<std::vector<std::string>>;
constexpr std::size_t kLineWidth = 110;

std::string orUnknown(const std::optional<double>& value, int decimals) {
    return value ? fixed(*value, decimals) : "-";
}

std::string plusMinus(const MeanAndDeviation& value, int decimals) {
    return orUnknown(value.mean, decimals) + " ± " + orUnknown(value.deviation, decimals);
}

std::string metricOf(const Parameters& parameters) {
    return toString(findParameter("candidates", "metric")->get(parameters));
}

std::string trialsTable(const Evaluation& evaluation) {
    Rows rows = {
        {"trial", "FOD", "candidates", "unassociated points", "unassociated candidates", "false candidates", "cost"}};
    for (const EvaluatedTrial& trial : evaluation.trials) {
        const std::string fods = std::to_string(trial.fods.size());
        if (!trial.counts) {
            rows.push_back({trial.name, fods, "failed", "-", "-", "-", fixed(trial.cost, 3)});
            continue;
        }
        const TrialCounts& counts = *trial.counts;
        rows.push_back({trial.name, fods, std::to_string(counts.candidates), std::to_string(counts.unassociatedPoints),
                        std::to_string(counts.unassociatedCandidates), std::to_string(counts.falseCandidates),
                        fixed(trial.cost, 3)});
    }
    return textTable(rows);
}

std::string candidatesTable(const Evaluation& evaluation, const EvaluationSummary& summary) {
    return textTable(
        {{"metric", "total", "unassociated points", "unassociated", "false candidates", "distance error", "mean cost"},
         {"", "candidates", "per trial", "candidates per trial", "per trial", "per FOD [m]", ""},
         {metricOf(evaluation.settings.parameters), std::to_string(summary.totalCandidates),
          plusMinus(summary.unassociatedPoints, 1), plusMinus(summary.unassociatedCandidates, 2),
          plusMinus(summary.falseCandidates, 2), plusMinus(summary.distanceError_m, 3),
          orUnknown(summary.meanCost, 3)}});
}

std::vector<std::string> recallRow(const std::string& name, const Recall& recall) {
    return {name,
            std::to_string(recall.fods),
            std::to_string(recall.within30cm),
            std::to_string(recall.fods - recall.within30cm),
            orUnknown(recall.at30cm(), 2),
            orUnknown(recall.at15cm(), 2)};
}

std::string recallTable(const EvaluationSummary& summary) {
    Rows rows = {{"type", "FOD", "detected", "missed", "recall 0.30 m", "recall 0.15 m"}};
    for (const TypeRecall& type : summary.recallByType)
        rows.push_back(recallRow(type.type, type.recall));
    rows.push_back(recallRow("total", summary.recall));
    rows.push_back(recallRow("observed in the map", summary.recallObserved));
    return textTable(rows);
}

std::string photosTables(const EvaluationSummary& summary) {
    const PhotoSummary& photos = *summary.photos;
    Rows rows = {{"type", "FOD", "detected", "missed", "recall"}};
    for (const TypeRecall& type : summary.recallByType) {
        const double recall = static_cast<double>(type.photographed) / static_cast<double>(type.recall.fods);
        rows.push_back({type.type, std::to_string(type.recall.fods), std::to_string(type.photographed),
                        std::to_string(type.recall.fods - type.photographed), fixed(recall, 2)});
    }
    rows.push_back({"total", std::to_string(photos.fods), std::to_string(photos.fodsPhotographed),
                    std::to_string(photos.fods - photos.fodsPhotographed), orUnknown(photos.recall(), 2)});
    return "\nRelevance of the photos\n" +
           textTable({{"photos", "contain FOD", "no FOD", "precision", "photos per FOD", "metres"},
                      {std::to_string(photos.photos), std::to_string(photos.photosWithFod),
                       std::to_string(photos.photos - photos.photosWithFod), orUnknown(photos.precision(), 3),
                       orUnknown(photos.photosPerFod(), 2), fixed(photos.drive_m, 1)}}) +
           "\nFOD on at least one photo\n" + textTable(rows);
}

}  // namespace

std::string evaluationText(const Evaluation& evaluation) {
    const EvaluationSummary summary = summarize(evaluation.trials);
    std::string text = "Trials\n" + trialsTable(evaluation);
    text += "\nCandidates over " + std::to_string(evaluation.trials.size()) + " trials with a total of " +
            std::to_string(summary.fods) + " FOD\n" + candidatesTable(evaluation, summary);
    text += "\nFOD with a candidate within 0.30 m\n" + recallTable(summary);
    if (summary.photos) text += photosTables(summary);
    for (const EvaluatedTrial& trial : evaluation.trials)
        if (!trial.failure.empty()) text += "\n" + trial.name + " failed: " + trial.failure + "\n";
    text += "\nHow it was counted\n";
    for (const std::string& line : howCounted(evaluation))
        text += wrapped(line, kLineWidth);
    return text;
}

}  // namespace fodscope
