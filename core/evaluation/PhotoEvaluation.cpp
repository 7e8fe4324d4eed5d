// SPDX-License-Identifier: MIT
#include "core/evaluation/PhotoEvaluation.h"

#include <algorithm>
#include <set>

#include "core/evaluation/PhotoTrial.h"
#include "core/inspection/AutomaticInspection.h"
#include "core/simulation/SimulatedRobot.h"

namespace fodscope {
namespace {

/// An evaluation's inspections are counted, not kept.
class NoJournal : public Journal {
  public:
    void recordHeader(const InspectionHeader&) override {}
    void recordReference(const SourceFile&, const ReferenceMap&) override {}
    void recordMap(const SourceFile&) override {}
    void recordParameters(const Parameters&) override {}
    void recordDetection(const DetectionRecord&, int) override {}
    void recordPlan(const OccupancyGrid&, const VisitPlan&, const std::vector<Visit>&) override {}
    void recordRoute(const InspectionRoute&, const std::vector<Visit>&) override {}
    void recordVisit(const Visit&) override {}
    void recordPhoto(const Photo&) override {}
    void recordLabelSet(const LabelSet&) override {}
    void recordDecision(const Decision&) override {}
    void recordReport(const ReportRecord&) override {}
};

/// The robot's own pictures are thrown away: it takes them small, with the same field of view, and what the camera of
/// full size sees from there is computed.
SimulatedRobotSettings robotFor(const CameraSettings& camera, const Progress& progress) {
    SimulatedRobotSettings settings = robotWith(scaledTo(camera, 64));
    settings.waitForRendering = true;
    settings.isWaitOver = [&progress] { return progress.isCancelled(); };
    return settings;
}

class TrialPhotographer {
  public:
    TrialPhotographer(const Trial& trial, const PhotoTrial& place) : place_(place) {
        counts_.isPhotographed.assign(trial.fods.size(), 0);
    }

    PhotoAnswer look(const Photo& photo) {
        ++counts_.photos;
        photographed_.insert(photo.candidateIds.begin(), photo.candidateIds.end());
        const std::vector<std::uint8_t> seen = place_.fodSeenFrom(photo.T_map_from_camera);
        if (std::ranges::find(seen, 1) != seen.end()) ++counts_.photosWithFod;
        for (std::size_t i = 0; i < seen.size(); ++i)
            if (seen[i] != 0) counts_.isPhotographed[i] = 1;
        return {};
    }

    PhotoCounts counts(const InspectionState& state, const CandidateSet& candidates) const {
        PhotoCounts result = counts_;
        result.drive_m = state.plan ? state.plan->length_m : 0.0;
        result.nearestNext_m = state.plan ? state.plan->nearestNextLength_m.value_or(0.0) : 0.0;
        for (const Candidate& candidate : candidates.candidates)
            if (!photographed_.contains(candidate.id)) ++result.candidatesWithoutPhoto;
        if (!state.plan) return result;
        for (const CandidateView& view : state.plan->views) {
            if (view.share > 0.0 && view.rest != WaypointStatus::Ok) ++result.candidatesInPart;
            if (view.share == 0.0) ++result.reasons[toString(view.rest)];
        }
        return result;
    }

  private:
    const PhotoTrial& place_;
    std::set<std::string> photographed_;
    PhotoCounts counts_;
};

PhotoCounts photograph(const Trial& trial, const std::filesystem::path& file,
                       const std::shared_ptr<const ReferenceMap>& reference, const Parameters& parameters,
                       const DetectionResult& detection, Progress& progress) {
    progress.report("reading the world", 0.0);
    const PhotoTrial place(trial, file, parameters.camera);
    TrialPhotographer photographer(trial, place);
    AutomaticInspectionInput input;
    input.referenceSource.path = "reference";
    input.reference = reference;
    input.mapSource.path = trial.map.string();
    input.parameters = parameters;
    input.detection = detection;
    input.grid_map = gridOf(trial, detection, detection.floorHeight_m, parameters.occupancy);
    input.robotStart_map = place.robotStart_map();
    const auto robot = makeSimulatedRobot(place.world(), input.grid_map, detection.denoisedMap, parameters.costMap,
                                          robotFor(parameters.camera, progress));
    NoJournal journal;
    Inspection inspection(InspectionState(), journal);
    const AutomaticLabeller look{"evaluation", [&](const Photo& photo) { return photographer.look(photo); }};
    inspectAutomatically(input, *robot, look, inspection, progress);
    return photographer.counts(inspection.state(), *detection.candidates);
}

}  // namespace

PhotoTaker makePhotoTaker(const std::filesystem::path& worlds, std::span<const Trial> trials,
                          std::shared_ptr<const ReferenceMap> reference, const Parameters& parameters) {
    requireWorlds(worlds, trials);
    return [worlds, reference = std::move(reference), parameters](const Trial& trial, const DetectionResult& detection,
                                                                  Progress& progress) {
        return photograph(trial, worldFile(worlds, trial), reference, parameters, detection, progress);
    };
}

}  // namespace fodscope
