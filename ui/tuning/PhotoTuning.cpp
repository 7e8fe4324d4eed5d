// SPDX-License-Identifier: MIT
#include "ui/tuning/PhotoTuning.h"

#include "ui/tuning/TuningSearch.h"

namespace fodscope {

PhotoTuningOutcome runPhotoTuning(const PhotoTuningRequest& request, Progress& progress) {
    PhotoTuningOutcome outcome;
    outcome.measured = request.measured;
    Parameters measuring = request.parameters;
    // The local statistical test is made only where it is asked for.
    if (request.search.grid.metric == Metric::ChiSquare)
        measuring.candidates = usualCandidateSettings(Metric::ChiSquare, measuring);
    if (!outcome.measured) {
        outcome.measured =
            std::make_shared<const PhotoSearchTrials>(request.reference, readTrials(request.folder), request.worlds,
                                                      measuring, TrialPlacement::Registered, progress);
    }
    outcome.result = searchPhotos(*outcome.measured, request.search, progress);
    outcome.inEffect = request.parameters.candidates;
    PhotoSearchSettings one = request.search;
    one.grid = gridOf(outcome.inEffect);
    outcome.outcomeInEffect = searchPhotos(*outcome.measured, one, progress).outcomes.front();
    return outcome;
}

std::optional<PhotoOutcome> knownOutcome(const PhotoTuningOutcome& tuning, const CandidateSettings& settings) {
    if (settings == tuning.inEffect) return tuning.outcomeInEffect;
    const PhotoSearchResult& result = tuning.result;
    const std::size_t levels = result.leastPoints.size();
    const std::size_t thresholds = result.thresholds.size();
    for (std::size_t i = 0; i < result.outcomes.size(); ++i) {
        if (result.settingsAt({i / levels / thresholds, i / levels % thresholds, i % levels}) == settings)
            return result.outcomes[i];
    }
    return std::nullopt;
}

}  // namespace fodscope
