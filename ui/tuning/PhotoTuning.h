// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "core/evaluation/PhotoSearch.h"

namespace fodscope {

struct PhotoTuningRequest {
    std::filesystem::path folder;
    /// Worlds of the trials.
    std::filesystem::path worlds;
    std::shared_ptr<const ReferenceMap> reference;
    /// Those in effect: they say how the trials are brought to candidates and planned for, and what the search is
    /// compared with.
    Parameters parameters;
    PhotoSearchSettings search;
    /// From an earlier search over the same; null: made anew.
    std::shared_ptr<const PhotoSearchTrials> measured;
};

struct PhotoTuningOutcome {
    std::shared_ptr<const PhotoSearchTrials> measured;
    PhotoSearchResult result;
    CandidateSettings inEffect;
    /// What the settings in effect come to in the same trials; empty when they make too many candidates.
    std::optional<PhotoOutcome> outcomeInEffect;
};

/// Prepares the trials where that is needed, searches, and photographs with the settings in effect. For a worker
/// thread.
/// @throws Error; Cancelled
PhotoTuningOutcome runPhotoTuning(const PhotoTuningRequest& request, Progress& progress);

/// @return what settings come to where that is known: those in effect and those on the grid
std::optional<PhotoOutcome> knownOutcome(const PhotoTuningOutcome& tuning, const CandidateSettings& settings);

}  // namespace fodscope
