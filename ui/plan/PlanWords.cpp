// SPDX-License-Identifier: MIT
#include "ui/plan/PlanWords.h"

#include <QObject>
#include <QStringList>
#include <algorithm>
#include <cmath>

namespace fodscope {

namespace {

QString candidateWords(const PlanCandidate& candidate, const PlanScene& scene) {
    QStringList lines{QObject::tr("%1 · %2").arg(QString::fromStdString(candidate.id),
                                                 QString::fromStdString(toString(candidate.verdict)))};
    if (!candidate.noWaypointReason.empty()) {
        lines << (candidate.plannedShare > 0.0
                      ? QObject::tr("Only %1 % of it is photographed: %2")
                            .arg(std::floor(100.0 * candidate.plannedShare))
                            .arg(reasonInWords(candidate.noWaypointReason))
                      : QObject::tr("No waypoint: %1").arg(reasonInWords(candidate.noWaypointReason)));
    }
    for (const PlanWaypoint& waypoint : scene.waypoints) {
        const auto& ids = waypoint.candidateIds;
        if (std::find(ids.begin(), ids.end(), candidate.id) == ids.end()) continue;
        lines << QObject::tr("Photographed from %1").arg(QString::fromStdString(waypoint.id));
    }
    return lines.join(QLatin1Char('\n'));
}

QString waypointWords(const PlanWaypoint& waypoint) {
    QStringList candidates;
    for (const std::string& id : waypoint.candidateIds)
        candidates << QString::fromStdString(id);
    QString text = QObject::tr("%1 · %2").arg(QString::fromStdString(waypoint.id),
                                              QString::fromStdString(toString(waypoint.state)));
    if (!candidates.isEmpty()) text += QObject::tr("\nLooks at %1").arg(candidates.join(QStringLiteral(", ")));
    if (!waypoint.reason.empty()) text += QLatin1Char('\n') + QString::fromStdString(waypoint.reason);
    return text;
}

QString cellWords(const PlanScene& scene, const Eigen::Vector2d& point_map) {
    if (!scene.costMap || !scene.costMap->grid.contains(scene.costMap->grid.cellAt(point_map))) return {};
    const CostMap& map = *scene.costMap;
    const CellIndex cell = map.grid.cellAt(point_map);
    QString word;
    if (map.grid.at(cell) == Cell::Unknown) {
        word = QObject::tr("not observed");
    } else if (map.grid.at(cell) == Cell::Occupied) {
        word = QObject::tr("obstacle");
    } else if (!map.costs.empty() && map.costAt(cell) >= kCostInscribed) {
        word = QObject::tr("too near an obstacle for the robot");
    } else if (!map.reachable.empty() && !map.isReachable(cell)) {
        word = QObject::tr("out of the robot's reach");
    } else {
        word = QObject::tr("free");
    }
    return QObject::tr("%1\nx %2 m, y %3 m").arg(word).arg(point_map.x(), 0, 'f', 2).arg(point_map.y(), 0, 'f', 2);
}

}  // namespace

QString reasonInWords(const std::string& waypointStatus) {
    if (waypointStatus == toString(WaypointStatus::Unreachable)) return QObject::tr("the robot does not get near it");
    if (waypointStatus == toString(WaypointStatus::Hidden))
        return QObject::tr("it is hidden from every place in reach");
    if (waypointStatus == toString(WaypointStatus::TooCloseToWall)) {
        return QObject::tr("every place to see it from is too close to an obstacle");
    }
    if (waypointStatus == toString(WaypointStatus::OutsideGrid)) return QObject::tr("it lies outside the grid");
    if (waypointStatus == toString(WaypointStatus::TooHigh))
        return QObject::tr("it rises out of the camera's picture from every place in reach");
    if (waypointStatus == toString(WaypointStatus::TooNear))
        return QObject::tr("it does not fit into the camera's picture from any place in reach");
    if (waypointStatus == toString(WaypointStatus::TooFar))
        return QObject::tr("it is too small in the camera's picture from every place in reach");
    if (waypointStatus == toString(WaypointStatus::LeftOut)) return QObject::tr("the operator left it out");
    return QString::fromStdString(waypointStatus);
}

QString planToolTip(const PlanScene& scene, const PlanHit& hit, const Eigen::Vector2d& point_map) {
    for (const PlanCandidate& candidate : scene.candidates) {
        if (hit.item == PlanItem::Candidate && candidate.id == hit.id) return candidateWords(candidate, scene);
    }
    for (const PlanWaypoint& waypoint : scene.waypoints) {
        if (hit.item == PlanItem::Waypoint && waypoint.id == hit.id) return waypointWords(waypoint);
    }
    return cellWords(scene, point_map);
}

}  // namespace fodscope
