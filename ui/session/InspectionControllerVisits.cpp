// SPDX-License-Identifier: MIT
// Plan, robot and visits of the inspection controller.
#include <QFileInfo>

#include "core/common/Error.h"
#include "core/simulation/SimulatedRobot.h"
#include "ui/session/InspectionController.h"

namespace fodscope {
namespace {

/// What the planner reads of a state; photos stay where they are.
InspectionState planInput(const InspectionState& state) {
    InspectionState input;
    input.reference = state.reference;
    input.parameters = state.parameters;
    input.detection = state.detection;
    return input;
}

}  // namespace

std::optional<Pose2> InspectionController::robotStart() const {
    if (robotStart_) return robotStart_;
    const auto& robot = visits_.robotState();
    if (robot && robot->pose_map) return robot->pose_map;
    if (state().plan) return state().plan->start_map;
    return std::nullopt;
}

void InspectionController::setRobotStart(const Pose2& pose_map) {
    robotStart_ = pose_map;
    emit robotChanged();
}

void InspectionController::loadGrid(const QString& yamlFile) {
    if (!attempt([&] { givenGrid_ = readMapServerGrid(yamlFile.toStdString()); })) return;
    emit noticeRaised(tr("The plan will be made on the grid %1.").arg(QFileInfo(yamlFile).fileName()));
    emit planChanged();
}

GridSources InspectionController::gridSources() const {
    GridSources sources;
    sources.ready = givenGrid_ ? givenGrid_ : robotGrid_;
    if (!sources.ready && state().grid_map) sources.ready = state().grid_map;
    if (map_) sources.map = map_->cloud;
    if (state().detection) sources.detection = *state().detection;
    return sources;
}

void InspectionController::planVisits() {
    const std::optional<Pose2> start = robotStart();
    const bool ready = attempt([&] {
        if (!state().detection || !state().detection->candidates)
            throw Error("plan", "there are no candidates yet", "align the map and find candidates first");
        if (!start)
            throw Error("robot", "nobody knows where it stands", "connect a robot, or give its start pose in step 4");
    });
    if (!ready) return;
    runFor(Step::Visit, tr("planning the visits"),
           [this, input = planInput(state()), sources = gridSources(),
            start = *start](Progress& progress) -> TaskRunner::Adopt {
               progress.report("making the grid", 0.0);
               const OccupancyGrid grid = makeGrid(sources);
               const VisitPlan plan = planInspection(input, grid, start, progress);
               return [this, grid, plan] { keepPlan(grid, plan); };
           });
}

void InspectionController::connectRobot(std::unique_ptr<RobotLink> robot) {
    robotStart_.reset();
    robotGrid_.reset();
    visits_.setRobot(std::move(robot));
    InspectionHeader header = state().header;
    header.robot = visits_.robotName().toStdString();
    if (inspection_ && header.robot != state().header.robot) setHeader(header);
    emit robotChanged();
}

void InspectionController::connectWorldRobot(const QString& worldFile) {
    if (!inspection_) return;
    runFor(Step::Visit, tr("building the world of the simulated robot"),
           [this, worldFile, sources = gridSources()](Progress& progress) -> TaskRunner::Adopt {
               progress.report("reading the world", 0.0);
               auto world = std::make_shared<const World>(readWorld(worldFile.toStdString()));
               const OccupancyGrid grid = makeGrid(sources);
               return [this, world, grid, map = sources.map] {
                   world_ = world;
                   connectRobot(makeSimulatedRobot(world, grid, map, state().parameters.costMap,
                                                   robotWith(state().parameters.camera)));
               };
           });
}

void InspectionController::stopRobot() {
    visits_.stop();
    emit noticeRaised(tr("STOP: every goal was cancelled. This is not the robot's safety stop."));
}

void InspectionController::keepVisit(const Visit& visit) {
    if (!inspection_) return;
    if (!attempt([&] { inspection_->updateVisit(visit); })) {
        // Nothing may be sent that is not on record.
        visits_.stop();
        return;
    }
    emit visitsChanged();
    emit stepsChanged();
}

void InspectionController::keepPhoto(const Photo& photo) {
    if (!inspection_) return;
    QString id;
    const bool kept = attempt([&] { id = QString::fromStdString(inspection_->addPhoto(photo).id); });
    if (!kept) {
        // A photo that cannot be kept must not be followed by others that are lost as well.
        visits_.stop();
        return;
    }
    refreshVerdicts();
    emit photosChanged();
    emit photoArrived(id);
    emit decisionsChanged();
    emit stepsChanged();
    if (selectedPhoto_.isEmpty()) selectPhoto(id);
}

}  // namespace fodscope
