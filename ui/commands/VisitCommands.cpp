// SPDX-License-Identifier: MIT
#include "ui/commands/VisitCommands.h"

#include <algorithm>

#include "ui/commands/StopChanges.h"

namespace fodscope {

LoadGridCommand::LoadGridCommand(CommandContext& context)
    : Command(context, QStringLiteral("visit.grid"), QObject::tr("Use a grid file…")) {
    setPicture(Icon::Grid);
    setToolTip(QObject::tr("A map_server YAML; without one the grid is made from the map or comes from the robot"));
}

void LoadGridCommand::run() {
    const QString file = files().openFile(window(), QObject::tr("Occupancy grid of map_server"),
                                          QObject::tr("Grids (*.yaml *.yml);;All files (*)"));
    if (!file.isEmpty()) controller().loadGrid(file);
}

bool LoadGridCommand::isAvailable() const {
    return controller().isOpen() && !controller().candidatesAreFrozen();
}

ConnectWorldRobotCommand::ConnectWorldRobotCommand(CommandContext& context)
    : Command(context, QStringLiteral("robot.world"), QObject::tr("Simulated robot, world file…")) {
    setPicture(Icon::Robot);
}

void ConnectWorldRobotCommand::run() {
    const QString file = files().openFile(window(), QObject::tr("World for the simulated robot"),
                                          QObject::tr("Worlds (*.json);;All files (*)"));
    if (!file.isEmpty()) controller().connectWorldRobot(file);
}

bool ConnectWorldRobotCommand::isAvailable() const {
    return controller().state().detection && controller().state().detection->field;
}

ConnectBuiltinRobotCommand::ConnectBuiltinRobotCommand(CommandContext& context)
    : Command(context, QStringLiteral("robot.builtin"), QObject::tr("Simulated robot, built-in tank")) {
    setPicture(Icon::Robot);
}

void ConnectBuiltinRobotCommand::run() {
    controller().connectBuiltinRobot();
}

bool ConnectBuiltinRobotCommand::isAvailable() const {
    return controller().isOpen() && controller().isOnBuiltinTank() && !controller().visits().hasRobot();
}

PlanVisitsCommand::PlanVisitsCommand(CommandContext& context)
    : Command(context, QStringLiteral("visit.plan"), QObject::tr("Plan visits")) {
    setPicture(Icon::Route);
    setToolTip(QObject::tr("A pose to photograph each candidate from, and the order to drive them in"));
}

void PlanVisitsCommand::run() {
    controller().planVisits();
}

bool PlanVisitsCommand::isAvailable() const {
    const auto& detection = controller().state().detection;
    return detection && detection->candidates && !detection->candidates->candidates.empty() &&
           !controller().candidatesAreFrozen();
}

ShiftWaypointCommand::ShiftWaypointCommand(CommandContext& context, int step)
    : Command(context, step < 0 ? QStringLiteral("visit.earlier") : QStringLiteral("visit.later"),
              step < 0 ? QObject::tr("Earlier") : QObject::tr("Later")),
      step_(step) {
    setToolTip(step < 0 ? QObject::tr("Visits the selected waypoint one place earlier")
                        : QObject::tr("Visits the selected waypoint one place later"));
}

void ShiftWaypointCommand::run() {
    shiftStop(controller(), controller().selectedWaypoint(), step_);
}

bool ShiftWaypointCommand::isAvailable() const {
    const auto index = stopIndex(controller(), controller().selectedWaypoint());
    if (!index || controller().candidatesAreFrozen()) return false;
    return step_ < 0 ? *index > 0 : *index + 1 < controller().stops().size();
}

RemoveWaypointCommand::RemoveWaypointCommand(CommandContext& context)
    : Command(context, QStringLiteral("visit.remove"), QObject::tr("Remove")) {
    setToolTip(
        QObject::tr("Takes the selected waypoint out of the plan; double click on the floor adds one, and "
                    "waypoints can be dragged"));
}

void RemoveWaypointCommand::run() {
    removeStop(controller(), controller().selectedWaypoint());
}

bool RemoveWaypointCommand::isAvailable() const {
    return stopIndex(controller(), controller().selectedWaypoint()).has_value() && !controller().candidatesAreFrozen();
}

StartVisitsCommand::StartVisitsCommand(CommandContext& context)
    : Command(context, QStringLiteral("visit.start"), QObject::tr("Start visits")) {
    setPicture(Icon::Play);
}

void StartVisitsCommand::run() {
    controller().visits().start();
}

bool StartVisitsCommand::isAvailable() const {
    const auto& visits = controller().visits();
    const auto state = visits.runnerState();
    return visits.hasRobot() && visits.hasPlan() && (state == RunnerState::Idle || state == RunnerState::Paused);
}

void StartVisitsCommand::refresh() {
    Command::refresh();
    setText(controller().candidatesAreFrozen() ? QObject::tr("Resume visits") : QObject::tr("Start visits"));
}

PauseVisitsCommand::PauseVisitsCommand(CommandContext& context)
    : Command(context, QStringLiteral("visit.pause"), QObject::tr("Pause after this visit")) {
    setPicture(Icon::Pause);
}

void PauseVisitsCommand::run() {
    controller().visits().pause();
}

bool PauseVisitsCommand::isAvailable() const {
    return controller().visits().runnerState() == RunnerState::Running;
}

TogglePauseCommand::TogglePauseCommand(CommandContext& context)
    : Command(context, QStringLiteral("visit.toggle"), QObject::tr("Pause or resume the visits")) {
    setKeys({QKeySequence(Qt::Key_Space)});
}

void TogglePauseCommand::run() {
    if (controller().visits().runnerState() == RunnerState::Running)
        controller().visits().pause();
    else
        controller().visits().start();
}

bool TogglePauseCommand::isAvailable() const {
    return controller().visits().hasRobot() && controller().visits().hasPlan();
}

SkipVisitCommand::SkipVisitCommand(CommandContext& context)
    : Command(context, QStringLiteral("visit.skip"), QObject::tr("Skip")) {
    setPicture(Icon::Skip);
    setToolTip(QObject::tr("Gives up the visit under way and goes on with the next"));
}

void SkipVisitCommand::run() {
    controller().visits().skip();
}

bool SkipVisitCommand::isAvailable() const {
    return controller().visits().runnerState() == RunnerState::Running;
}

RetryVisitCommand::RetryVisitCommand(CommandContext& context)
    : Command(context, QStringLiteral("visit.retry"), QObject::tr("Visit again")) {
    setPicture(Icon::Retry);
    setToolTip(QObject::tr("Puts the visit of the selected candidate back into the plan"));
}

const Visit* RetryVisitCommand::chosenVisit() const {
    const InspectionState& state = controller().state();
    if (!state.plan || controller().selectedCandidate().isEmpty()) return nullptr;
    const std::string candidate = controller().selectedCandidate().toStdString();
    for (const Waypoint& waypoint : state.plan->waypoints) {
        if (std::ranges::find(waypoint.candidateIds, candidate) == waypoint.candidateIds.end()) continue;
        const auto visit = std::ranges::find(state.visits, waypoint.id, &Visit::waypointId);
        if (visit != state.visits.end() && waypoint.pose_map) return &*visit;
    }
    return nullptr;
}

void RetryVisitCommand::run() {
    if (const Visit* visit = chosenVisit()) controller().visits().retry(visit->waypointId);
}

bool RetryVisitCommand::isAvailable() const {
    const Visit* visit = chosenVisit();
    return visit != nullptr && controller().visits().hasRobot() &&
           (visit->state == VisitState::Failed || visit->state == VisitState::Skipped ||
            visit->state == VisitState::Done);
}

StopCommand::StopCommand(CommandContext& context)
    : Command(context, QStringLiteral("robot.stop"), QObject::tr("STOP")) {
    setPicture(Icon::Stop);
    setKeys({QKeySequence(QStringLiteral("Ctrl+."))});
    setToolTip(QObject::tr("Cancels every goal of the robot at once. This is not a safety stop."));
}

void StopCommand::run() {
    controller().stopRobot();
}

}  // namespace fodscope
