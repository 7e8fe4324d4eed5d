// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "core/evaluation/EvaluationReport.h"
#include "core/evaluation/Summary.h"
#include "core/inspection/JsonNumbers.h"
#include "core/inspection/ParameterJson.h"

namespace fodscope {
namespace {

using Json = nlohmann::ordered_json;

Json orNull(const std::optional<double>& value) {
    return value ? rounded(*value) : Json(nullptr);
}

Json jsonOf(const MeanAndDeviation& value) {
    return {{"mean", orNull(value.mean)}, {"std", orNull(value.deviation)}, {"n", value.count}};
}

Json jsonOf(const Recall& recall) {
    return {{"0.15", orNull(recall.at15cm())}, {"0.30", orNull(recall.at30cm())}, {"fods", recall.fods}};
}

Json jsonOf(const EvaluatedFod& fod) {
    Json json = {{"type", fod.type}, {"observed", fod.observed}, {"distance_m", orNull(fod.distance_m)}};
    json["nearest"] = fod.nearest ? Json(*fod.nearest) : Json(nullptr);
    if (fod.photographed) json["photographed"] = *fod.photographed;
    return json;
}

Json registrationOf(const EvaluatedTrial& trial) {
    return {{"quality", qualityWord(trial.registration.quality)},
            {"rms_m", rounded(trial.registration.rms_m)},
            {"overlap", rounded(trial.registration.overlap)},
            {"corner_error_m", orNull(trial.cornerError_m)}};
}

Json jsonOf(const EvaluatedTrial& trial) {
    Json json = {{"name", trial.name}, {"fods", Json::array()}};
    for (const EvaluatedFod& fod : trial.fods)
        json["fods"].push_back(jsonOf(fod));
    const auto count = [&](std::size_t TrialCounts::*member) {
        return trial.counts ? Json((*trial.counts).*member) : Json(nullptr);
    };
    json["candidates"] = count(&TrialCounts::candidates);
    json["unassociated_candidates"] = count(&TrialCounts::unassociatedCandidates);
    json["false_candidates"] = count(&TrialCounts::falseCandidates);
    json["unassociated_points"] = count(&TrialCounts::unassociatedPoints);
    json["cost"] = rounded(trial.cost);
    json["failure"] = trial.failure.empty() ? Json(nullptr) : Json(trial.failure);
    json["registration"] = registrationOf(trial);
    if (trial.photos)
        json["photos"] = {{"photos", trial.photos->photos},
                          {"photos_with_fod", trial.photos->photosWithFod},
                          {"candidates_without_photo", trial.photos->candidatesWithoutPhoto},
                          {"candidates_in_part", trial.photos->candidatesInPart},
                          {"metres", rounded(trial.photos->drive_m)},
                          {"metres_nearest_next", rounded(trial.photos->nearestNext_m)}};
    return json;
}

Json recallByType(const EvaluationSummary& summary) {
    Json json = Json::object();
    for (const TypeRecall& type : summary.recallByType)
        json[type.type] = jsonOf(type.recall);
    return json;
}

Json photosOf(const EvaluationSummary& summary) {
    const PhotoSummary& photos = *summary.photos;
    Json byType = Json::object();
    for (const TypeRecall& type : summary.recallByType)
        byType[type.type] = rounded(static_cast<double>(type.photographed) / static_cast<double>(type.recall.fods));
    return {{"precision", orNull(photos.precision())},
            {"recall", orNull(photos.recall())},
            {"recall_by_type", byType},
            {"photos_per_fod", orNull(photos.photosPerFod())},
            {"metres", rounded(photos.drive_m)},
            {"photos", photos.photos},
            {"photos_with_fod", photos.photosWithFod},
            {"fods_photographed", photos.fodsPhotographed},
            {"candidates_without_photo", photos.candidatesWithoutPhoto},
            {"candidates_in_part", photos.candidatesInPart},
            {"reasons_without_waypoint", photos.reasons},
            {"metres_nearest_next", rounded(photos.nearestNext_m)}};
}

Json jsonOf(const EvaluationSummary& summary) {
    Json json = {{"fods", summary.fods},
                 {"failed_trials", summary.failedTrials},
                 {"total_candidates", summary.totalCandidates},
                 {"unassociated_points_per_trial", jsonOf(summary.unassociatedPoints)},
                 {"unassociated_candidates_per_trial", jsonOf(summary.unassociatedCandidates)},
                 {"false_candidates_per_trial", jsonOf(summary.falseCandidates)},
                 {"distance_error_m", jsonOf(summary.distanceError_m)},
                 {"recall", jsonOf(summary.recall)},
                 {"recall_observed", jsonOf(summary.recallObserved)},
                 {"recall_by_type", recallByType(summary)},
                 {"mean_cost", orNull(summary.meanCost)}};
    if (summary.photos) json["photos"] = photosOf(summary);
    return json;
}

}  // namespace

std::string evaluationJson(const Evaluation& evaluation, const SourceFile& reference) {
    Json root = {{"schema", "fodscope.evaluation/1"}};
    root["reference"] = {{"file", reference.path}, {"points", reference.points}, {"sha256", reference.sha256}};
    root["settings"] = jsonParameters(evaluation.settings.parameters);
    root["lambda"] = rounded(evaluation.settings.lambda);
    root["stored_transforms"] = evaluation.settings.placement == TrialPlacement::Stored;
    root["trials"] = Json::array();
    for (const EvaluatedTrial& trial : evaluation.trials)
        root["trials"].push_back(jsonOf(trial));
    root["nominal_maps"] = evaluation.nominalMaps;
    root["summary"] = jsonOf(summarize(evaluation.trials));
    root["how_counted"] = howCounted(evaluation);
    return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace fodscope
