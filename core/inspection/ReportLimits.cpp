// SPDX-License-Identifier: MIT
#include "core/inspection/ReportLimits.h"

#include <algorithm>
#include <cmath>

#include "core/inspection/ReportText.h"

namespace fodscope {
namespace {

void addIf(std::vector<std::string>& sentences, bool condition, const std::string& sentence) {
    if (condition) sentences.push_back(sentence);
}

std::size_t countOf(const std::vector<CandidateVerdict>& verdicts, Verdict verdict) {
    return static_cast<std::size_t>(std::ranges::count(verdicts, verdict, &CandidateVerdict::verdict));
}

/// An object needs two voxels a side to stand out from one that is noise.
std::string smallestObject(const Parameters& parameters) {
    if (parameters.discrepancy.downSampling == DownSampling::Random) {
        return "Only a random " + percent(parameters.discrepancy.randomRatio) +
               " of the map's points were compared, so small objects, and larger ones that lie flat or touch a "
               "surface, can be missed. The rate at which objects are found was not measured in this inspection.";
    }
    return "Objects smaller than about " + length(2.0 * parameters.discrepancy.voxelSize_m) +
           " (two voxels of the comparison), and larger ones that lie flat or touch a surface, can be missed; a map "
           "that is coarser than its voxels raises this size. The rate at which objects are found was not measured in "
           "this inspection.";
}

void addCoverageLimits(std::vector<std::string>& limits, const DetectionRecord& detection) {
    if (!detection.coverage) {
        limits.push_back("Which surfaces were observed is not recorded.");
        return;
    }
    const double observed = detection.coverage->observedShare;
    addIf(limits, observed < 1.0,
          "Part of the reference surface was not observed (" + fixed(100.0 - std::floor(observed * 100.0 + 1e-9), 0) +
              " %): FOD there would not be noticed.");
    limits.push_back(
        "Observed means that points of the map lie near the surface. No sensor rays were used, so the space between "
        "the surfaces is not known to have been looked through.");
}

void addReferenceLimits(std::vector<std::string>& limits, const InspectionState& state) {
    if (!state.reference) return;
    addIf(limits, !state.reference->hasCovariance(),
          "The reference map has no covariances: how much a place varies between maps without FOD is not known.");
    const auto untrained = std::ranges::count(state.reference->untrained, std::uint8_t{1});
    addIf(limits, untrained > 0,
          "At " + counted(static_cast<std::size_t>(untrained), "reference point", "reference points") +
              " no nominal map supports the covariance; they give no Mahalanobis discrepancy.");
}

}  // namespace

std::vector<std::string> limitsOf(const InspectionState& state) {
    std::vector<std::string> limits;
    if (!state.detection) {
        limits.push_back("No map has been compared with a reference map.");
        return limits;
    }
    const DetectionRecord& detection = *state.detection;
    if (!detection.candidates) {
        limits.push_back("The map is not aligned with the reference map well enough to be compared.");
        return limits;
    }
    limits.push_back(smallestObject(detection.parameters));
    addCoverageLimits(limits, detection);
    if (const auto& height = detection.parameters.discrepancy.cropHeight_m) {
        limits.push_back("Nothing was examined higher than z = " + fixed(*height, 2) + " m in the reference frame.");
    }
    addIf(limits, detection.parameters.discrepancy.cropToReference,
          "Points of the map outside the bounds of the reference map were not examined.");
    addIf(limits, detection.registration.quality == RegistrationQuality::Given,
          "The alignment was given by the user and not searched for.");
    addReferenceLimits(limits, state);
    const std::size_t withoutPhoto = countOf(verdictsOf(state), Verdict::NotPhotographed);
    addIf(limits, withoutPhoto > 0,
          counted(withoutPhoto, "candidate has", "candidates have") + " no photo and could not be decided.");
    limits.push_back("A photo shows what faces the camera: what lies behind or beneath is not seen.");
    return limits;
}

std::vector<std::string> missingForIssue(const InspectionState& state) {
    std::vector<std::string> missing;
    addIf(missing, state.header.inspector.empty(), "The inspector's name is not recorded.");
    addIf(missing, state.header.ship.empty(), "The ship is not recorded.");
    addIf(missing, state.header.tank.empty(), "The tank is not recorded.");
    if (!state.detection) {
        missing.push_back("No map has been compared with a reference map.");
        return missing;
    }
    if (!state.detection->candidates) {
        missing.push_back("The map is not aligned with the reference map.");
        return missing;
    }
    const std::vector<CandidateVerdict> verdicts = verdictsOf(state);
    addIf(missing, !verdicts.empty() && !state.plan, "The visits to the candidates have not been planned.");
    const auto waiting = static_cast<std::size_t>(
        std::ranges::count_if(state.visits, [](const Visit& visit) { return !isOver(visit.state); }));
    addIf(missing, waiting > 0, counted(waiting, "visit has", "visits have") + " not been made.");
    const std::size_t undecided = countOf(verdicts, Verdict::Undecided);
    addIf(missing, undecided > 0,
          counted(undecided, "candidate waits", "candidates wait") + " for a decision on its photos.");
    return missing;
}

}  // namespace fodscope
