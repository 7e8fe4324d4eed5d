// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/evaluation/Association.h"
#include "core/evaluation/TrialSelection.h"

namespace fodscope {

/// What became of one FOD of a trial.
struct EvaluatedFod {
    std::string type;
    bool observed = true;
    /// To the nearest candidate; empty without candidates.
    std::optional<double> distance_m;
    /// Id of that candidate.
    std::optional<std::string> nearest;
    /// Whether a photo shows it; empty when no photos were taken.
    std::optional<bool> photographed;
};

/// The photos of a trial's candidates.
struct PhotoCounts {
    std::size_t photos = 0;
    std::size_t photosWithFod = 0;
    /// Candidates that no photo was taken of: no pose sees them, or the drive failed.
    std::size_t candidatesWithoutPhoto = 0;
    /// Planned drive along the cost map.
    double drive_m = 0.0;
    /// One for each FOD of the trial, in its order.
    std::vector<std::uint8_t> isPhotographed;
    /// What the drive would be always to the nearest waypoint that is left.
    double nearestNext_m = 0.0;
    /// Candidates of which photos show a part only.
    std::size_t candidatesInPart = 0;
    /// Why candidates have no waypoint: how many for each reason.
    std::map<std::string, std::size_t> reasons{};
};

/// What the program made of a trial's candidates: absent where the map could not be aligned.
struct TrialCounts {
    std::size_t candidates = 0;
    std::size_t unassociatedCandidates = 0;
    std::size_t falseCandidates = 0;
    /// Voxels above the threshold, before clustering, that are not in an associated candidate.
    std::size_t unassociatedPoints = 0;
};

struct EvaluatedTrial {
    std::string name;
    std::vector<EvaluatedFod> fods;
    std::optional<TrialCounts> counts;
    /// Why the trial failed; empty when it did not.
    std::string failure;
    /// Mean distance + λ · unassociated candidates; 7.5 m where there are no candidates, a failed trial included.
    double cost = 0.0;
    RegistrationResult registration;
    /// Greatest displacement of a corner of the reference's bounds between the transform used and the stored one. The
    /// stored one fits the map as a whole, so the map's own drift is in it.
    std::optional<double> cornerError_m;
    std::optional<PhotoCounts> photos;
};

/// Photographs the candidates of a trial, see PhotoEvaluation.h.
using PhotoTaker = std::function<PhotoCounts(const Trial&, const DetectionResult&, Progress&)>;

struct EvaluationSettings {
    Parameters parameters;
    /// Cost of an unassociated candidate, metres.
    double lambda = kUnassociatedWeight_m;
    TrialPlacement placement = TrialPlacement::Registered;
};

struct Evaluation {
    EvaluationSettings settings;
    std::vector<EvaluatedTrial> trials;
    /// Maps without FOD, left out of every figure.
    std::vector<std::string> nominalMaps;
};

/// Scores one detection against a trial's ground truth. All in the map frame.
EvaluatedTrial evaluateDetection(const Trial& trial, const DetectionResult& detection, double lambda);

/// Runs the detection on every trial that has FOD and scores it. The registration is the program's own, from the
/// trial's T_cad_from_map_initial where there is one; a trial that cannot be aligned has failed and is told by name.
/// @param takePhotos may be empty
/// @throws Error when no trial has FOD, a map cannot be read, or stored transforms are asked for and missing; all
///         trials at fault are named at once; Cancelled
Evaluation evaluateTrials(const std::shared_ptr<const ReferenceMap>& reference, std::span<const Trial> trials,
                          const EvaluationSettings& settings, const PhotoTaker& takePhotos, Progress& progress);

}  // namespace fodscope
