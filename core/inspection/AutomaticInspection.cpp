// SPDX-License-Identifier: MIT
#include "core/inspection/AutomaticInspection.h"

#include <algorithm>

#include "core/common/Error.h"

namespace fodscope {
namespace {

/// Step of the inspection's own clock.
constexpr double kTick_s = 0.1;
/// A map may have to be assembled first.
constexpr double kMapTimeout_s = 120.0;

double shareOver(const std::vector<Visit>& visits) {
    const auto over = std::ranges::count_if(visits, [](const Visit& visit) { return isOver(visit.state); });
    return visits.empty() ? 1.0 : static_cast<double>(over) / static_cast<double>(visits.size());
}

/// @return a time by which even a plan whose every try fails by its time-outs is over
double longestMission_s(const VisitPlan& plan, const VisitSettings& settings) {
    constexpr double kLongestPause_s = 60.0;
    const double drive_s = settings.acknowledgeTimeout_s + settings.departureTimeout_s + settings.driveTimeout_s +
                           settings.localiseTimeout_s + settings.linkTimeout_s + kLongestPause_s;
    const double photo_s = settings.photoTimeout_s + kLongestPause_s;
    return 60.0 + static_cast<double>(plan.waypoints.size()) *
                      (drive_s * settings.maximumTries + photo_s * settings.maximumPhotoTries);
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

/// What is driven, and what the people who wait for it are told.
struct Mission {
    std::string stage;
    VisitPlan plan;
    std::vector<Visit> visits;
};

void drive(RobotLink& robot, const Mission& mission, const AutomaticLabeller& labeller, Inspection& inspection,
           Progress& progress) {
    const VisitSettings& settings = inspection.state().parameters.visits;
    VisitRunner runner(robot, mission.plan, mission.visits, settings, photoMarks(inspection.state()));
    robot.connect();
    runner.start();
    const double longest_s = longestMission_s(mission.plan, settings);
    std::string lastMessage;
    for (double now_s = 0.0; runner.state() != RunnerState::Finished; now_s += kTick_s) {
        if (progress.isCancelled()) runner.stop();
        progress.report(mission.stage, shareOver(runner.visits()));
        VisitProgress step = runner.advance(now_s);
        if (!step.messages.empty()) lastMessage = step.messages.back();
        adoptProgress(std::move(step), labeller, inspection);
        // Nobody is there to look and to resume.
        if (runner.state() == RunnerState::Paused)
            throw Error(robot.name(), lastMessage, "see to the robot, then resume the session");
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
    resumeAutomatically(robot, labeller, inspection, progress);
}

void resumeAutomatically(RobotLink& robot, const AutomaticLabeller& labeller, Inspection& inspection,
                         Progress& progress) {
    const InspectionState& state = inspection.state();
    if (!state.plan) throw Error("session", "it has no plan to drive", "plan the visits first");
    drive(robot, {"photographing the candidates", *state.plan, state.visits}, labeller, inspection, progress);
}

void driveRoute(RobotLink& robot, Inspection& inspection, Progress& progress) {
    const InspectionState& state = inspection.state();
    if (state.route.poses.empty()) throw Error("route", "it has no poses", "add poses, or load a route");
    const AutomaticLabeller nobody{"", [](const Photo&) { return PhotoAnswer(); }};
    drive(robot, {"driving the route", planOf(state.route), state.routeVisits}, nobody, inspection, progress);
}

std::shared_ptr<const PointCloud> fetchMap(RobotLink& robot, Progress& progress) {
    robot.connect();
    robot.requestMap();
    std::string lastMessage = "it sent none in time";
    for (double now_s = 0.0; now_s < kMapTimeout_s; now_s += kTick_s) {
        progress.report("fetching the map", now_s / kMapTimeout_s);
        for (const RobotEvent& event : robot.poll(now_s)) {
            if (const auto* received = std::get_if<MapReceived>(&event); received != nullptr && received->map)
                return received->map;
            if (const auto* message = std::get_if<LinkMessage>(&event)) lastMessage = message->text;
        }
    }
    throw Error(robot.name(), "sent no map: " + lastMessage, "check that it maps, or load the map from a file");
}

}  // namespace fodscope
