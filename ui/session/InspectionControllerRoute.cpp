// SPDX-License-Identifier: MIT
// The inspection route of the controller: edited, driven, and the map that the robot made on it.
#include <QDir>
#include <QFileInfo>

#include "core/cloud/PointCloudIo.h"
#include "core/common/Error.h"
#include "core/common/Files.h"
#include "core/simulation/FloorGrid.h"
#include "core/simulation/SimulatedRobot.h"
#include "ui/session/InspectionController.h"

namespace fodscope {
namespace {

/// Beside the session, under a name that nothing has yet.
QString freeMapName(const QString& session) {
    const QFileInfo info(session);
    const QDir folder = info.dir();
    const QString base = info.completeBaseName() + QStringLiteral("-map");
    QString name = base;
    for (int number = 2; folder.exists(name + QStringLiteral(".pcd")); ++number)
        name = QStringLiteral("%1-%2").arg(base).arg(number);
    return folder.filePath(name + QStringLiteral(".pcd"));
}

}  // namespace

const OccupancyGrid* InspectionController::routeGrid() const {
    if (givenGrid_) return &*givenGrid_;
    if (robotGrid_) return &*robotGrid_;
    return state().grid_map ? &*state().grid_map : nullptr;
}

bool InspectionController::isRouteWanted() const {
    return isOpen() && (!state().route.poses.empty() || (visits_.hasRobot() && !state().mapSource));
}

void InspectionController::setRoute(const InspectionRoute& route, const QString& act) {
    const InspectionRoute before = state().route;
    if (!keepRoute(route) || state().route == before) return;
    const InspectionRoute after = state().route;
    history_.add({act, [this, before] { keepRoute(before); }, [this, after] { keepRoute(after); }});
    emit historyChanged();
}

bool InspectionController::keepRoute(const InspectionRoute& route) {
    const bool kept = inspection_ && attempt([&] {
                          if (isOnRoute_ && visits_.runnerState() == RunnerState::Running)
                              throw Error("route", "the robot is driving it", "pause or stop it first");
                          inspection_->setRoute(route);
                      });
    if (!kept) return false;
    if (isOnRoute_) leaveRoute();
    emit routeChanged();
    return true;
}

void InspectionController::removeRoutePose(const QString& poseId) {
    InspectionRoute route = state().route;
    std::erase_if(route.poses, [&](const RoutePose& pose) { return pose.id == poseId.toStdString(); });
    setRoute(route, tr("pose taken out"));
}

void InspectionController::selectRoutePose(const QString& poseId) {
    if (poseId == selectedRoutePose_) return;
    selectedRoutePose_ = poseId;
    emit routePoseSelected(poseId);
}

void InspectionController::loadRoute(const QString& yamlFile) {
    attempt([&] { setRoute(readRoute(yamlFile.toStdString()), tr("route %1").arg(QFileInfo(yamlFile).fileName())); });
}

void InspectionController::saveRoute(const QString& yamlFile) {
    if (!attempt([&] { writeFile(yamlFile.toStdString(), routeYaml(state().route)); })) return;
    emit noticeRaised(tr("The route was saved as %1.").arg(QFileInfo(yamlFile).fileName()));
}

void InspectionController::connectMappingRobot(const QString& worldFile) {
    if (!inspection_) return;
    runFor(Step::Map, tr("building the world of the simulated robot"),
           [this, worldFile](Progress& progress) -> TaskRunner::Adopt {
               progress.report("reading the world", 0.0);
               auto world = std::make_shared<const World>(readWorld(worldFile.toStdString()));
               const OccupancyGrid grid = exploredFloor(*world);
               return [this, world, grid] {
                   world_ = world;
                   SimulatedRobotSettings settings;
                   settings.mapping.emplace();
                   connectRobot(makeSimulatedRobot(world, grid, nullptr, state().parameters.costMap, settings));
                   emit routeChanged();
               };
           });
}

void InspectionController::driveRoute() {
    const bool ready = attempt([&] {
        if (state().route.poses.empty())
            throw Error("route", "it has no poses", "add poses on the plan, or load a route");
        if (!visits_.hasRobot()) throw Error("robot", "none is connected", "connect one first");
    });
    if (!ready) return;
    if (!isOnRoute_) {
        isOnRoute_ = true;
        visits_.setPlan(planOf(state().route), state().routeVisits, state().parameters.visits, photoMarks(state()));
    }
    visits_.start();
    emit visitsChanged();
}

void InspectionController::driveRouteAgain() {
    InspectionRoute route = state().route;
    for (RoutePose& pose : route.poses)
        pose.id.clear();
    setRoute(route, tr("drive the route again"));
}

/// The robot has been everywhere on the route: its map is complete.
void InspectionController::followRoute() {
    if (!isOnRoute_ || visits_.runnerState() != RunnerState::Finished) return;
    leaveRoute();
    fetchMap();
}

void InspectionController::leaveRoute() {
    isOnRoute_ = false;
    if (state().plan) {
        visits_.setPlan(*state().plan, state().visits, state().parameters.visits, photoMarks(state()));
    } else {
        visits_.clearPlan();
    }
}

void InspectionController::fetchMap() {
    if (!visits_.hasRobot()) return;
    isMapAwaited_ = true;
    visits_.requestMap();
    emit noticeRaised(tr("The map is fetched from the robot."));
}

void InspectionController::keepMap(const std::shared_ptr<const PointCloud>& map) {
    if (!inspection_ || !map || !std::exchange(isMapAwaited_, false)) return;
    const QString file = freeMapName(sessionPath());
    runFor(Step::Map, tr("keeping the robot's map"), [this, map, file](Progress& progress) -> TaskRunner::Adopt {
        writePointCloud(file.toStdString(), *map);
        const MapFile loaded = readMapFile(file.toStdString(), progress);
        return [this, loaded, file] {
            adoptMap(loaded.source, loaded.map);
            emit noticeRaised(tr("The robot's map was kept as %1.").arg(QFileInfo(file).fileName()));
        };
    });
}

}  // namespace fodscope
