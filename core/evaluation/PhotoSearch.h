// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/evaluation/ParameterSearch.h"
#include "core/evaluation/TrialSelection.h"
#include "core/inspection/Parameters.h"

namespace fodscope {

/// The search for the fewest photos at a wanted recall. The paper's search knows nothing of waypoints and camera; here
/// every grid point's candidates are planned for, and what the photos show is computed in the trials' worlds.
struct PhotoSearchSettings {
    /// Share of the FOD that has to be on at least one photo, over all trials.
    double recall = 0.8;
    /// Cutoffs, thresholds and least points, and what is not searched for. Its lambda is not used.
    ParameterSearchSettings grid;
    /// Grid points with more candidates than this in some trial are left out: nobody drives to so many.
    int mostCandidates = 40;

    bool operator==(const PhotoSearchSettings&) const = default;
};

/// The grid that the search takes unless another is given: coarser than the paper's, for each point is planned, and
/// from thresholds that leave the most discrepant voxels only.
ParameterSearchSettings usualPhotoGrid(const CandidateSettings& method);

/// What the photos of all trials show at one grid point.
struct PhotoOutcome {
    std::size_t photos = 0;
    std::size_t photosWithFod = 0;
    /// On at least one photo.
    std::size_t fodsShown = 0;
    std::size_t candidates = 0;
    /// Candidates that no photo shows.
    std::size_t candidatesWithoutPhoto = 0;

    std::optional<double> precision() const;
    bool operator==(const PhotoOutcome&) const = default;
};

/// A grid point with its outcome.
struct PhotoChoice {
    GridPoint point;
    PhotoOutcome outcome;
};

struct PhotoSearchResult {
    PhotoSearchSettings settings;
    std::size_t trialCount = 0;
    std::size_t fodCount = 0;
    std::vector<double> cutoffs_m;
    std::vector<double> thresholds;
    std::vector<int> leastPoints;
    /// Every grid point: the least points change fastest, then the threshold, then the cutoff. Empty for those with too
    /// many candidates.
    std::vector<std::optional<PhotoOutcome>> outcomes;
    /// For each number of FOD that some grid point shows and that no point with fewer photos exceeds, the one with the
    /// fewest photos, ascending: the best that thresholds can do. Of equal ones that with more photos showing FOD, then
    /// the lower cutoff, the higher threshold, the fewer points.
    std::vector<PhotoChoice> curve;
    /// The first of the curve with the wanted recall; empty when none has it.
    std::optional<PhotoChoice> best;

    double recallOf(const PhotoOutcome& outcome) const;
    CandidateSettings settingsAt(const GridPoint& point) const;
};

/// Trials brought as far as the discrepancy, each with its grid and world.
class PhotoSearchTrials {
  public:
    /// Reads and measures the maps of all trials with FOD, and their worlds.
    /// @throws Error as measureTrials() and makePhotoTaker() do, and where the robot cannot stand; Cancelled
    PhotoSearchTrials(const std::shared_ptr<const ReferenceMap>& reference, std::span<const Trial> trials,
                      const std::filesystem::path& worlds, const Parameters& parameters, TrialPlacement placement,
                      Progress& progress);
    ~PhotoSearchTrials();
    PhotoSearchTrials(PhotoSearchTrials&&) noexcept;

    const std::vector<std::string>& nominalMaps() const;
    /// Of the maps that could not be aligned: name and why.
    const std::map<std::string, std::string>& failures() const;

  private:
    friend PhotoSearchResult searchPhotos(const PhotoSearchTrials&, const PhotoSearchSettings&, Progress&);
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// Parallel; the result does not depend on the number of threads. The photos at a grid point are those that `evaluate
/// --photos` takes with its values. In a trial that could not be aligned nothing is photographed and all FOD missed.
/// @throws Error for settings that parameterSearchProblems() names, a recall that is none, no trials, or thresholds
///         whose automatic lower end is beyond the upper; Cancelled
PhotoSearchResult searchPhotos(const PhotoSearchTrials& trials, const PhotoSearchSettings& settings,
                               Progress& progress);

/// The curve and the best point in words, a line each.
std::vector<std::string> photoSearchFindings(const PhotoSearchResult& result);

/// Where the values come from, for the head of a parameter file.
std::vector<std::string> photoSearchMethod(const PhotoSearchResult& result);

/// The curve as JSON ("fodscope.photo-search/1"): precision, recall, photos and values of each of its points, the best.
std::string photoSearchJson(const PhotoSearchResult& result);

}  // namespace fodscope
