// SPDX-License-Identifier: MIT
#include "ui/commands/StopChanges.h"

#include <utility>

namespace fodscope {

std::optional<std::size_t> stopIndex(const InspectionController& controller, const QString& waypointId) {
    if (!controller.state().plan) return std::nullopt;
    std::size_t index = 0;
    for (const Waypoint& waypoint : controller.state().plan->waypoints) {
        if (!waypoint.pose_map) continue;
        if (waypoint.id == waypointId.toStdString()) return index;
        ++index;
    }
    return std::nullopt;
}

void removeStop(InspectionController& controller, const QString& waypointId) {
    const auto index = stopIndex(controller, waypointId);
    if (!index) return;
    std::vector<PlannedStop> stops = controller.stops();
    stops.erase(stops.begin() + static_cast<std::ptrdiff_t>(*index));
    controller.changeStops(stops, QObject::tr("removal of %1").arg(waypointId));
}

void shiftStop(InspectionController& controller, const QString& waypointId, int step) {
    const auto index = stopIndex(controller, waypointId);
    std::vector<PlannedStop> stops = controller.stops();
    const auto target = index ? static_cast<std::ptrdiff_t>(*index) + step : -1;
    if (target < 0 || target >= static_cast<std::ptrdiff_t>(stops.size())) return;
    std::swap(stops[*index], stops[static_cast<std::size_t>(target)]);
    controller.changeStops(stops, QObject::tr("order of %1").arg(waypointId));
}

}  // namespace fodscope
