// SPDX-License-Identifier: MIT
#include "core/inspection/AutomaticInspection.h"

#include <algorithm>

#include "core/common/Error.h"

namespace fodscope {
namespace {

constexpr const char* kStage = "photographing the candidates";
/// Step of the inspection's own clock.
constexpr double kTick_s = 0.1;

double shareOver(const std::vector<Visit>& visits) {
    const auto over = std::ranges::count_if(visits, [](const Visit& visit) { return isOver(visit.state); });
    return visits.empty() ? 1.0 : static_cast<double>(over) / static_cast<double>(visits.size());
}

/// @return a time by which even a plan whose every try fails by its time-outs is over
double longestMission_s(const VisitPlan& plan, const VisitSettings& settings) {
    const double oneTry_s = settings.acknowledgeTimeout_s + settings.driveTimeout_s + settings.photoTimeout_s + 10.0;
    return 60.0 + static_cast<double>(plan.waypoints.size()) * oneTry_s * std::max(settings.maximumTries, 1);
}

void adoptProgress(VisitProgress&& step, const AutomaticLabeller& labeller, Inspection& inspection) {
    // Photos first: a visit that is recorded as done has its photo on record, whatever happens in between.
    for (Photo& photo : step.photos) {
        const Photo kept = inspection.addPhoto(std::move(photo));
        const PhotoAnswer answer = labeller.answer(kept);
        if (answer.labels.empty()) continue;
        inspection.decide(kept.id, labeller.name, answer.labels, answer.comment, UtcTime::now());
    }
    for (const Visit& visit : step.changedVisits)
        inspection.updateVisit(visit);
}

void drive(RobotLink& robot, const AutomaticLabeller& labeller, Inspection& inspection, Progress& progress) {
    const InspectionState& state = inspection.state();
    const VisitSettings& settings = state.parameters.visits;
    VisitRunner runner(robot, *state.plan, state.visits, settings);
    robot.connect();
    runner.start();
    const double longest_s = longestMission_s(*state.plan, settings);
    for (double now_s = 0.0; runner.state() != RunnerState::Finished; now_s += kTick_s) {
        if (progress.isCancelled()) runner.stop();
        progress.report(kStage, shareOver(state.visits));
        adoptProgress(runner.advance(now_s), labeller, inspection);
        if (now_s > longest_s) {
            runner.stop();
            throw Error(robot.name(), "did not finish its visits", "check the robot, or look at the visits' reasons");
        }
    }
    robot.disconnect();
}

}  // namespace

void inspectAutomatically(const AutomaticInspectionInput& input, RobotLink& robot, const AutomaticLabeller& labeller,
                          Inspection& inspection, Progress& progress) {
    inspection.setReference(input.referenceSource, input.reference);
    inspection.setMap(input.mapSource);
    inspection.setParameters(input.parameters);
    inspection.setLabelSet(input.labelSet);
    inspection.adoptDetection(input.parameters, input.detection);
    if (!input.detection.candidates || input.detection.candidates->candidates.empty()) return;
    const VisitPlan plan = planInspection(inspection.state(), input.grid_map, input.robotStart_map, progress);
    inspection.adoptPlan(input.grid_map, plan);
    drive(robot, labeller, inspection, progress);
}

}  // namespace fodscope
