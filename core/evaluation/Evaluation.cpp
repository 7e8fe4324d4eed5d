// SPDX-License-Identifier: MIT
#include "core/evaluation/Evaluation.h"

#include <Eigen/Geometry>
#include <algorithm>


namespace fodscope {
namespace {

std::size_t unassociatedPoints(const CandidateSet& set, const Association& association) {
    std::size_t points = set.pointsAboveThreshold;
    for (std::size_t i = 0; i < set.candidates.size(); ++i)
        if (association.isAssociated[i]) points -= set.candidates[i].voxels.size();
    return points;
}

double cornerError(const ReferenceMap& reference, const Transform& used, const Transform& stored) {
    Eigen::AlignedBox3d bounds;
    for (const Eigen::Vector3d& point : reference.points)
        bounds.extend(point);
    double greatest_m = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d at = bounds.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
        greatest_m = std::max(greatest_m, (used * (stored.inverse() * at) - at).norm());
    }
    return greatest_m;
}

/// Passes the progress of one trial on as a part of the whole.
Progress partOf(Progress& whole, const std::string& name, std::size_t index, std::size_t count) {
    return Progress([&whole, name, index, count](const std::string& stage, double fraction) {
        whole.report(name + " (" + std::to_string(index + 1) + "/" + std::to_string(count) + "): " + stage, fraction);
    });
}

EvaluatedTrial evaluateTrial(const std::shared_ptr<const ReferenceMap>& reference, const Trial& trial,
                             const EvaluationSettings& settings, const PhotoTaker& takePhotos, Progress& progress) {
    progress.report("reading the map", 0.0);
    DetectionPipeline pipeline = pipelineFor(trial, reference, settings.placement);
    const DetectionResult& detection = pipeline.run(settings.parameters, progress);
    EvaluatedTrial result = evaluateDetection(trial, detection, settings.lambda);
    if (!result.counts) return result;
    if (trial.T_cad_from_map)
        result.cornerError_m =
            cornerError(*reference, detection.registration.T_reference_from_map, *trial.T_cad_from_map);
    if (takePhotos) {
        result.photos = takePhotos(trial, detection, progress);
        for (std::size_t i = 0; i < result.fods.size(); ++i)
            result.fods[i].photographed = result.photos->isPhotographed.at(i) != 0;
    }
    return result;
}

}  // namespace

EvaluatedTrial evaluateDetection(const Trial& trial, const DetectionResult& detection, double lambda) {
    EvaluatedTrial result;
    result.name = trial.name;
    result.registration = detection.registration;
    std::vector<Eigen::Vector3d> fods, candidates;
    for (const GroundTruthFod& fod : trial.fods)
        fods.push_back(fod.centroid_map);
    if (detection.candidates)
        for (const Candidate& candidate : detection.candidates->candidates)
            candidates.push_back(candidate.centroid_map);
    const Association association = associate(fods, candidates, lambda);
    for (std::size_t i = 0; i < trial.fods.size(); ++i) {
        const AssociatedFod& found = association.fods[i];
        result.fods.push_back({trial.fods[i].type, trial.fods[i].observed, found.distance_m, std::nullopt, {}});
        if (found.nearest) result.fods.back().nearest = detection.candidates->candidates[*found.nearest].id;
    }
    result.cost = association.cost;
    if (!detection.candidates) {
        result.failure = detection.registration.summary;
        return result;
    }
    result.counts = TrialCounts{candidates.size(), association.unassociatedCandidates, association.falseCandidates,
                                unassociatedPoints(*detection.candidates, association)};
    return result;
}

Evaluation evaluateTrials(const std::shared_ptr<const ReferenceMap>& reference, std::span<const Trial> trials,
                          const EvaluationSettings& settings, const PhotoTaker& takePhotos, Progress& progress) {
    const auto [withFod, nominalMaps] = selectTrials(trials, settings.placement);
    Evaluation evaluation;
    evaluation.settings = settings;
    evaluation.nominalMaps = nominalMaps;
    for (std::size_t i = 0; i < withFod.size(); ++i) {
        Progress part = partOf(progress, withFod[i]->name, i, withFod.size());
        try {
            evaluation.trials.push_back(evaluateTrial(reference, *withFod[i], settings, takePhotos, part));
        } catch (const Error& error) {
            rethrowNaming(*withFod[i], error);
        }
    }
    return evaluation;
}

}  // namespace fodscope
