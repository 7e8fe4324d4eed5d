// SPDX-License-Identifier: MIT
#include "core/evaluation/SearchTrials.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <chrono>

#include "core/evaluation/SharedProgress.h"

namespace fodscope {
namespace {

struct Measured {
    SearchTrial trial;
    std::string failure;
    std::map<std::string, double> stageSeconds;
};

Measured measure(const std::shared_ptr<const ReferenceMap>& reference, const Trial& trial, const Parameters& parameters,
                 TrialPlacement placement, Progress& progress) {
    const auto begin = std::chrono::steady_clock::now();
    progress.report("reading the map", 0.0);
    DetectionPipeline pipeline = pipelineFor(trial, reference, placement);
    const double readSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const DetectionResult& detection = pipeline.run(parameters, progress, PipelineEnd::Discrepancy);
    Measured measured;
    measured.trial.name = trial.name;
    measured.trial.field = detection.field;
    measured.trial.T_reference_from_map = detection.registration.T_reference_from_map;
    for (const GroundTruthFod& fod : trial.fods)
        measured.trial.fods_map.push_back(fod.centroid_map);
    if (!detection.field) measured.failure = detection.registration.summary;
    measured.stageSeconds = detection.stageSeconds;
    measured.stageSeconds["load"] = readSeconds;
    return measured;
}

}  // namespace

MeasuredTrials measureTrials(const std::shared_ptr<const ReferenceMap>& reference, std::span<const Trial> trials,
                             const Parameters& parameters, TrialPlacement placement, Progress& progress) {
    MeasuredTrials result;
    const TrialSelection selection = selectTrials(trials, placement);
    const std::vector<const Trial*>& withFod = selection.withFod;
    result.nominalMaps = selection.nominalMaps;
    SharedProgress shared(progress, "measuring " + std::to_string(withFod.size()) + " trials",
                          static_cast<double>(withFod.size()));
    std::vector<Measured> measured(withFod.size());
    tbb::parallel_for(
        std::size_t{0}, withFod.size(),
        [&](std::size_t i) {
            Progress part = shared.forPart();
            try {
                // A thread that waits for a stage of one trial must not begin with another trial.
                tbb::this_task_arena::isolate(
                    [&] { measured[i] = measure(reference, *withFod[i], parameters, placement, part); });
            } catch (const Error& error) {
                rethrowNaming(*withFod[i], error);
            }
            shared.add(1.0);
        },
        tbb::simple_partitioner());
    for (Measured& one : measured) {
        if (!one.failure.empty()) result.failures[one.trial.name] = one.failure;
        for (const auto& [stage, seconds] : one.stageSeconds)
            result.stageSeconds[stage] += seconds;
        result.trials.push_back(std::move(one.trial));
    }
    return result;
}

}  // namespace fodscope
