// SPDX-License-Identifier: MIT
// The built-in tank of the inspection controller.
#include "core/simulation/SimulatedRobot.h"
#include "ui/session/BuiltinInspection.h"
#include "ui/session/InspectionController.h"

namespace fodscope {

void InspectionController::createBuiltinTank(const QString& file) {
    InspectionHeader header = newInspectionHeader();
    header.title = tr("Built-in tank").toStdString();
    header.tank = tr("built-in tank (simulated)").toStdString();
    if (!createSession(file, header)) return;
    runFor(Step::Reference, tr("simulating the built-in tank"), [this](Progress& progress) -> TaskRunner::Adopt {
        const auto builtin = std::make_shared<const BuiltinInspection>(makeBuiltinInspection(progress));
        return [this, builtin] {
            adoptReference(builtin->reference);
            adoptBuiltinRobot(*builtin);
            isBuiltinPending_ = true;
            adoptMap(builtin->map.source, builtin->map.map);
        };
    });
}

void InspectionController::adoptBuiltinRobot(const BuiltinInspection& builtin) {
    world_ = builtin.world;
    connectRobot(makeSimulatedRobot(builtin.world, builtin.grid_map, builtin.map.map.cloud, state().parameters.costMap,
                                    robotWith(state().parameters.camera)));
}

void InspectionController::connectBuiltinRobot() {
    if (!inspection_) return;
    runFor(Step::Visit, tr("building the world of the simulated robot"),
           [this](Progress& progress) -> TaskRunner::Adopt {
               const auto builtin = std::make_shared<const BuiltinInspection>(makeBuiltinInspection(progress));
               return [this, builtin] { adoptBuiltinRobot(*builtin); };
           });
}

bool InspectionController::isOnBuiltinTank() const {
    return state().mapSource && state().mapSource->path == kBuiltinMapName;
}

}  // namespace fodscope
