// SPDX-License-Identifier: MIT
#include "ui/commands/RouteCommands.h"

#include <algorithm>

namespace fodscope {

LoadRouteCommand::LoadRouteCommand(CommandContext& context)
    : Command(context, QStringLiteral("route.load"), QObject::tr("Load route…")) {
    setPicture(Icon::Open);
}

void LoadRouteCommand::run() {
    const QString file = files().openFile(window(), QObject::tr("Inspection route"),
                                          QObject::tr("Routes (*.yaml *.yml);;All files (*)"));
    if (!file.isEmpty()) controller().loadRoute(file);
}

bool LoadRouteCommand::isAvailable() const {
    return controller().isOpen() && !controller().isDrivingRoute();
}

SaveRouteCommand::SaveRouteCommand(CommandContext& context)
    : Command(context, QStringLiteral("route.save"), QObject::tr("Save route…")) {
    setPicture(Icon::Save);
}

void SaveRouteCommand::run() {
    const QString file = files().saveFile(window(), QObject::tr("Inspection route"), QStringLiteral("route.yaml"),
                                          QObject::tr("Routes (*.yaml)"));
    if (!file.isEmpty()) controller().saveRoute(file);
}

bool SaveRouteCommand::isAvailable() const {
    return !controller().state().route.poses.empty();
}

ConnectMappingRobotCommand::ConnectMappingRobotCommand(CommandContext& context)
    : Command(context, QStringLiteral("route.robot"), QObject::tr("Simulated robot that maps…")) {
    setPicture(Icon::Robot);
    setToolTip(QObject::tr("A robot in a world file, which maps while it drives the route"));
}

void ConnectMappingRobotCommand::run() {
    const QString file = files().openFile(window(), QObject::tr("World for the simulated robot"),
                                          QObject::tr("Worlds (*.json);;All files (*)"));
    if (!file.isEmpty()) controller().connectMappingRobot(file);
}

bool ConnectMappingRobotCommand::isAvailable() const {
    return controller().isOpen() && !controller().visits().hasRobot();
}

DriveRouteCommand::DriveRouteCommand(CommandContext& context)
    : Command(context, QStringLiteral("route.drive"), QObject::tr("Drive the route")) {
    setPicture(Icon::Play);
    setToolTip(QObject::tr("Drives to each pose in turn, then fetches the robot's map"));
}

bool DriveRouteCommand::isDriven() const {
    const std::vector<Visit>& visits = controller().state().routeVisits;
    return !visits.empty() && std::ranges::all_of(visits, isOver, &Visit::state);
}

void DriveRouteCommand::run() {
    if (isDriven()) controller().driveRouteAgain();
    controller().driveRoute();
}

bool DriveRouteCommand::isAvailable() const {
    return !controller().state().route.poses.empty() && controller().visits().hasRobot() &&
           !controller().candidatesAreFrozen() && controller().visits().runnerState() != RunnerState::Running;
}

QString DriveRouteCommand::obstacle() const {
    if (controller().state().route.poses.empty()) return QObject::tr("the route has no poses");
    if (!controller().visits().hasRobot()) return QObject::tr("no robot is connected");
    if (controller().candidatesAreFrozen()) return QObject::tr("the visits to the candidates have begun");
    return QObject::tr("the robot is driving");
}

void DriveRouteCommand::refresh() {
    Command::refresh();
    const std::vector<Visit>& visits = controller().state().routeVisits;
    const bool hasBegun = std::ranges::any_of(visits, [](const Visit& visit) { return visit.tries > 0; });
    setText(isDriven() ? QObject::tr("Drive the route again")
            : hasBegun ? QObject::tr("Resume the route")
                       : QObject::tr("Drive the route"));
}

FetchMapCommand::FetchMapCommand(CommandContext& context)
    : Command(context, QStringLiteral("route.map"), QObject::tr("Fetch the robot's map")) {
    setPicture(Icon::Cloud);
}

void FetchMapCommand::run() {
    controller().fetchMap();
}

bool FetchMapCommand::isAvailable() const {
    return controller().visits().hasRobot() && !controller().candidatesAreFrozen() && !controller().isDrivingRoute();
}

}  // namespace fodscope
