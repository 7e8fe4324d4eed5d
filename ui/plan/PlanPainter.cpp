// SPDX-License-Identifier: MIT
#include "ui/plan/PlanPainter.h"

#include <QFontMetricsF>
#include <QObject>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/plan/PlanSigns.h"
#include "ui/theme/Colours.h"

namespace fodscope {

namespace {

/// Pixels of a layer per unit of the painter: as fine as the screen, or as a printer shows.
double layerScale(const QPainter& painter) {
    const double scale = std::abs(painter.transform().m11()) * painter.device()->devicePixelRatioF();
    return std::clamp(scale, 1.0, 3.0);
}

/// Hatching is painted as an image: clipping to ten thousand cells would take seconds on paper.
QImage hatchLayer(const QRectF& area, const QImage& mask, const QTransform& cellsToScreen, const QColor& colour,
                  bool falling, double scale) {
    QImage layer((area.size() * scale).toSize(), QImage::Format_ARGB32_Premultiplied);
    if (layer.isNull()) return layer;
    layer.fill(Qt::transparent);
    QPainter painter(&layer);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(scale, scale);
    painter.translate(-area.topLeft());
    painter.setPen(QPen(colour, 1.0));
    constexpr double kStep_px = 7.0;
    const double reach = area.width() + area.height();
    for (double along = 0.0; along < reach; along += kStep_px) {
        const QPointF start = area.topLeft() + QPointF(falling ? area.width() - along : along, 0.0);
        painter.drawLine(start, start + QPointF(falling ? area.height() : -area.height(), area.height()));
    }
    painter.setCompositionMode(QPainter::CompositionMode_DestinationIn);
    QImage keep(layer.size(), QImage::Format_ARGB32_Premultiplied);
    keep.fill(Qt::transparent);
    {
        QPainter masking(&keep);
        masking.scale(scale, scale);
        masking.translate(-area.topLeft());
        masking.setTransform(cellsToScreen, true);
        masking.drawImage(0, 0, mask);
    }
    painter.resetTransform();
    painter.drawImage(0, 0, keep);
    return layer;
}

void paintGrid(QPainter& painter, const QRectF& area, const CostMap& map, const PlanImages& images,
               const PlanTransform& transform, const Theme& theme) {
    QTransform cellsToScreen = gridToScreen(map.grid, transform);
    cellsToScreen.scale(images.cellsPerPixel, images.cellsPerPixel);
    painter.save();
    painter.setTransform(cellsToScreen, true);
    // Cells have edges: smoothing would show costs that nobody computed.
    painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
    painter.drawImage(0, 0, images.cells);
    painter.restore();
    const double scale = layerScale(painter);
    const QColor faint = hatchColour(theme, false);
    painter.drawImage(area, hatchLayer(area, images.unknown, cellsToScreen, faint, false, scale));
    const QColor strong = hatchColour(theme, true);
    painter.drawImage(area, hatchLayer(area, images.unreachable, cellsToScreen, strong, true, scale));
}

/// As an image: thousands of squares would make a page of the report slow to open.
void paintPoints(QPainter& painter, const QRectF& area, const PlanScene& scene, const PlanTransform& transform,
                 const Theme& theme) {
    if (scene.pointsFromAbove_map.empty()) return;
    const double scale = layerScale(painter);
    QImage layer((area.size() * scale).toSize(), QImage::Format_ARGB32_Premultiplied);
    if (layer.isNull()) return;
    layer.fill(Qt::transparent);
    QPainter dots(&layer);
    dots.scale(scale, scale);
    dots.translate(-area.topLeft());
    QColor colour = theme.muted;
    colour.setAlpha(110);
    const double edge = std::max(1.0, 0.015 * transform.pixelsPerMetre);
    for (const Eigen::Vector2d& point : scene.pointsFromAbove_map) {
        const QPointF place = transform.toScreen(point);
        dots.fillRect(QRectF(place.x() - 0.5 * edge, place.y() - 0.5 * edge, edge, edge), colour);
    }
    dots.end();
    painter.drawImage(area, layer);
}

void paintRoute(QPainter& painter, const PlanScene& scene, const PlanTransform& transform, const Theme& theme) {
    painter.setBrush(Qt::NoBrush);
    for (const PlanWaypoint& waypoint : scene.waypoints) {
        if (waypoint.drive_map.size() < 2) continue;
        QPolygonF line;
        for (const Eigen::Vector2d& point : waypoint.drive_map)
            line << transform.toScreen(point);
        const bool driven = waypoint.state == VisitState::Arrived || waypoint.state == VisitState::Photo ||
                            waypoint.state == VisitState::Done;
        QPen pen(theme.text, driven ? 2.0 : 1.5, driven ? Qt::SolidLine : Qt::DashLine, Qt::RoundCap, Qt::RoundJoin);
        pen.setColor(driven ? mixed(theme.text, theme.clear, 0.6) : theme.muted);
        painter.setPen(pen);
        painter.drawPolyline(line);
    }
    if (scene.start_map && !scene.waypoints.empty()) {
        const QPointF start = transform.toScreen({scene.start_map->x_m, scene.start_map->y_m});
        paintStartSign(painter, start, theme);
    }
}

void paintCones(QPainter& painter, const PlanScene& scene, const PlanTransform& transform, const PlanLook& look) {
    for (const PlanWaypoint& waypoint : scene.waypoints) {
        if (!waypoint.takesPhoto) continue;
        const bool selected = waypoint.id == look.selectedWaypoint;
        QColor fill = selected ? look.theme.accent : look.theme.text;
        fill.setAlpha(selected ? 60 : 22);
        paintViewCone(painter, transform.toScreen({waypoint.pose_map.x_m, waypoint.pose_map.y_m}),
                      scene.viewRange_m * transform.pixelsPerMetre, waypoint.pose_map.yaw_rad, scene.viewAngle_rad,
                      fill);
    }
}

void paintCandidates(QPainter& painter, const QRectF& area, const PlanScene& scene, const PlanTransform& transform,
                     const PlanLook& look, std::vector<QRectF>& taken) {
    for (const PlanCandidate& candidate : scene.candidates) {
        const double radius = candidateRing_px(candidate, transform);
        const QPointF centre = transform.toScreen(candidate.centroid_map);
        taken.emplace_back(centre - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius));
    }
    const QFontMetricsF metrics(painter.font());
    for (const PlanCandidate& candidate : scene.candidates) {
        const QString id = QString::fromStdString(candidate.id);
        const QPointF centre = transform.toScreen(candidate.centroid_map);
        const double radius = candidateRing_px(candidate, transform);
        const CandidateSign sign{centre,
                                 radius,
                                 candidateColour(id),
                                 candidate.verdict,
                                 candidate.id == look.selectedCandidate,
                                 !candidate.noWaypointReason.empty() && candidate.plannedShare == 0.0};
        paintCandidateSign(painter, sign, look.theme);
        if (!area.contains(centre)) continue;
        const QSizeF size(metrics.horizontalAdvance(id) + 8.0, metrics.height() + 2.0);
        const QRectF place = placeLabel(centre, radius, size, taken, area);
        taken.push_back(place);
        paintLeaderLabel(painter, centre, radius, place, id, sign.colour, sign.selected, look.theme);
    }
}

void paintWaypoints(QPainter& painter, const PlanScene& scene, const PlanTransform& transform, const PlanLook& look) {
    const std::vector<QPointF> discs = discCentres(scene, transform);
    for (std::size_t index = 0; index < discs.size(); ++index) {
        const PlanWaypoint& waypoint = scene.waypoints[index];
        const QPointF pose = transform.toScreen({waypoint.pose_map.x_m, waypoint.pose_map.y_m});
        painter.setPen(QPen(look.theme.muted, 1.0));
        painter.drawLine(pose, discs[index]);
        paintWaypointSign(painter, discs[index], QString::number(waypoint.number), waypoint.state,
                          waypoint.id == look.selectedWaypoint, waypoint.id == look.hovered, look.theme);
    }
}

void paintRobot(QPainter& painter, const QRectF& area, const PlanTransform& transform, const PlanRobot& robot,
                const std::vector<QRectF>& taken, const Theme& theme) {
    constexpr double kRobotRadius_m = 0.17;
    const double radius = std::max(9.0, kRobotRadius_m * transform.pixelsPerMetre);
    const QPointF place = transform.toScreen({robot.pose_map.x_m, robot.pose_map.y_m});
    const bool stale = !(robot.poseAge_s <= kStalePose_s);
    paintRobotSign(painter, place, radius, robot.pose_map.yaw_rad, stale, theme);
    if (!stale) return;
    const QString text = QObject::tr("robot: pose %1 s old").arg(robot.poseAge_s, 0, 'f', 0);
    const QFontMetricsF metrics(painter.font());
    const QSizeF size(metrics.horizontalAdvance(text) + 8.0, metrics.height() + 2.0);
    const QRectF plate = placeLabel(place, radius, size, taken, area);
    paintPlate(painter, plate, text, theme.attention, theme);
}

void paintScaleBar(QPainter& painter, const QRectF& area, const PlanTransform& transform, const Theme& theme) {
    const double length_m = scaleBarLength(transform.pixelsPerMetre, std::min(160.0, 0.3 * area.width()));
    const double length = length_m * transform.pixelsPerMetre;
    const QFontMetricsF metrics(painter.font());
    const QPointF right = area.bottomRight() - QPointF(16.0, 14.0);
    const QPointF left = right - QPointF(length, 0.0);
    QColor plate = theme.surface0;
    plate.setAlpha(200);
    painter.fillRect(QRectF(left - QPointF(8, metrics.height() + 6), right + QPointF(8, 8)), plate);
    painter.setPen(QPen(theme.text, 1.5));
    painter.drawLine(left, right);
    painter.drawLine(left - QPointF(0, 4), left + QPointF(0, 4));
    painter.drawLine(right - QPointF(0, 4), right + QPointF(0, 4));
    painter.drawText(QRectF(left - QPointF(60, metrics.height() + 4), right + QPointF(60, -4)), Qt::AlignCenter,
                     lengthInWords(length_m));
}

}  // namespace

void paintPlan(QPainter& painter, const QRectF& area, const PlanScene& scene, const PlanImages& images,
               const PlanTransform& transform, const PlanLook& look) {
    painter.save();
    painter.setClipRect(area, Qt::IntersectClip);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(area, look.theme.surface0);
    QFont font = painter.font();
    font.setPixelSize(std::max(1, static_cast<int>(std::lround(look.fontPixels))));
    painter.setFont(font);
    if (scene.costMap) paintGrid(painter, area, *scene.costMap, images, transform, look.theme);
    paintPoints(painter, area, scene, transform, look.theme);
    std::vector<QRectF> taken;
    if (look.showVisits) {
        paintCones(painter, scene, transform, look);
        paintRoute(painter, scene, transform, look.theme);
        for (const QPointF& disc : discCentres(scene, transform)) {
            taken.emplace_back(disc - QPointF(kWaypointDisc_px, kWaypointDisc_px),
                               QSizeF(2 * kWaypointDisc_px, 2 * kWaypointDisc_px));
        }
    }
    paintCandidates(painter, area, scene, transform, look, taken);
    if (look.showVisits) paintWaypoints(painter, scene, transform, look);
    if (look.robot) paintRobot(painter, area, transform, *look.robot, taken, look.theme);
    paintScaleBar(painter, area, transform, look.theme);
    painter.restore();
}

QImage planImage(const PlanScene& scene, const QSize& size_px, ThemeKind kind, const std::string& selectedCandidate) {
    QImage image(size_px, QImage::Format_RGB32);
    PlanLook look;
    look.theme = makeTheme(kind);
    look.selectedCandidate = selectedCandidate;
    image.fill(look.theme.surface1);
    QPainter painter(&image);
    QFont font = painter.font();
    font.setPixelSize(12);
    painter.setFont(font);
    QRectF area(QPointF(0, 0), QSizeF(size_px));
    const double legend = paintPlanLegend(painter, area, scene, look, false);
    const QRectF plan = area.adjusted(0, 0, 0, -legend);
    paintPlan(painter, plan, scene, planImages(scene, look.theme), fittedPlan(planExtent(scene), plan), look);
    paintPlanLegend(painter, QRectF(0, plan.bottom(), area.width(), legend), scene, look, true);
    return image;
}

}  // namespace fodscope
