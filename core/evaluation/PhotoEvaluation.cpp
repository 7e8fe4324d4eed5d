// SPDX-License-Identifier: MIT
#include "core/evaluation/PhotoEvaluation.h"

#include <algorithm>
#include <map>
#include <set>
#include <system_error>

#include "core/common/Error.h"
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

std::filesystem::path worldFile(const std::filesystem::path& worlds, const Trial& trial) {
    return worlds / (trial.name + ".json");
}

void requireWorlds(const std::filesystem::path& worlds, std::span<const Trial> trials) {
    std::string missing;
    for (const Trial& trial : trials) {
        std::error_code ignored;
        if (trial.isNominal() || std::filesystem::is_regular_file(worldFile(worlds, trial), ignored)) continue;
        missing += (missing.empty() ? "" : ", ") + trial.name + ".json";
    }
    if (!missing.empty())
        throw Error(worlds.string(), "the worlds of these trials are missing: " + missing,
                    "give the folder that holds a world NAME.json for each trial");
}

/// @return the world's objects that are the trial's FOD, in the trial's order
std::vector<std::size_t> objectsOf(const Trial& trial, const World& world, const std::string& subject) {
    std::multimap<std::string, std::size_t> fod;
    for (std::size_t i = 0; i < world.objects.size(); ++i)
        if (world.objects[i].fod) fod.emplace(world.objects[i].type, i);
    std::vector<std::size_t> objects;
    for (const GroundTruthFod& wanted : trial.fods) {
        const auto found = fod.find(wanted.type);
        if (found == fod.end()) {
            throw Error(subject, "holds no " + wanted.type + ", which the trial's ground truth lists",
                        "give the world that this trial was mapped in");
        }
        objects.push_back(found->second);
        fod.erase(found);
    }
    if (!fod.empty())
        throw Error(subject, "holds a " + fod.begin()->first + ", which the trial's ground truth does not list",
                    "give the world that this trial was mapped in");
    return objects;
}

OccupancyGrid gridOf(const Trial& trial, const DetectionResult& detection, const OccupancySettings& settings) {
    if (trial.grid) return readMapServerGrid(*trial.grid);
    return occupancyFromMap(detection.denoisedMap->points, detection.registration.T_reference_from_map,
                            detection.floorHeight_m, settings);
}

/// The robot's own pictures are thrown away: it takes them small, with the same field of view, and what the camera of
/// full size sees from there is computed.
SimulatedRobotSettings robotFor(const Progress& progress) {
    SimulatedRobotSettings settings;
    settings.waitForRendering = true;
    settings.isWaitOver = [&progress] { return progress.isCancelled(); };
    settings.camera.width_px = 64;
    settings.camera.height_px = 36;
    return settings;
}

class TrialPhotographer {
  public:
    TrialPhotographer(const Trial& trial, std::shared_ptr<const World> world, const std::string& subject)
        : objects_(objectsOf(trial, *world, subject)), world_(world), truth_(world, false) {
        counts_.isPhotographed.assign(trial.fods.size(), 0);
    }

    PhotoAnswer look(Photo photo) {
        ++counts_.photos;
        photographed_.insert(photo.candidateIds.begin(), photo.candidateIds.end());
        photo.intrinsics = intrinsicsOf(PhotoCameraSettings());
        const std::vector<VisibleFod> seen = truth_.fodOn(photo);
        if (!seen.empty()) ++counts_.photosWithFod;
        for (std::size_t i = 0; i < objects_.size(); ++i)
            if (std::ranges::any_of(seen, [&](const VisibleFod& fod) { return fod.object == objects_[i]; }))
                counts_.isPhotographed[i] = 1;
        return {};
    }

    PhotoCounts counts(const InspectionState& state, const CandidateSet& candidates) const {
        PhotoCounts result = counts_;
        result.drive_m = state.plan ? state.plan->length_m : 0.0;
        for (const Candidate& candidate : candidates.candidates)
            if (!photographed_.contains(candidate.id)) ++result.candidatesWithoutPhoto;
        return result;
    }

  private:
    std::vector<std::size_t> objects_;
    std::shared_ptr<const World> world_;
    GroundTruthLabeller truth_;
    std::set<std::string> photographed_;
    PhotoCounts counts_;
};

PhotoCounts photograph(const Trial& trial, const std::filesystem::path& file,
                       const std::shared_ptr<const ReferenceMap>& reference, const Parameters& parameters,
                       const DetectionResult& detection, Progress& progress) {
    progress.report("reading the world", 0.0);
    const auto world = std::make_shared<const World>(readWorld(file));
    TrialPhotographer photographer(trial, world, file.string());
    AutomaticInspectionInput input;
    input.referenceSource.path = "reference";
    input.reference = reference;
    input.mapSource.path = trial.map.string();
    input.parameters = parameters;
    input.detection = detection;
    input.grid_map = gridOf(trial, detection, parameters.occupancy);
    input.robotStart_map = poseFromTransform(world->T_map_from_world * transformFromPose(world->robotStart_world));
    const auto robot =
        makeSimulatedRobot(world, input.grid_map, detection.denoisedMap, parameters.costMap, robotFor(progress));
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
