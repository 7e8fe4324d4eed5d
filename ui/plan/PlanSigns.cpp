// SPDX-License-Identifier: MIT
#include "ui/plan/PlanSigns.h"

#include <QPainter>
#include <QPainterPath>
#include <cmath>

#include "ui/plan/PlanGeometry.h"
#include "ui/theme/Colours.h"

namespace fodscope {

namespace {

QPointF towards(const QPointF& from, double angle_rad, double distance) {
    return from + QPointF(std::cos(angle_rad), -std::sin(angle_rad)) * distance;
}

void paintTick(QPainter& painter, const QPointF& centre, const QColor& colour) {
    painter.setPen(QPen(colour, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(
        QPolygonF(QVector<QPointF>{centre + QPointF(-3, 0), centre + QPointF(-0.8, 2.4), centre + QPointF(3.2, -2.6)}));
}

void paintCross(QPainter& painter, const QPointF& centre, const QColor& colour) {
    painter.setPen(QPen(colour, 1.8, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(centre + QPointF(-2.5, -2.5), centre + QPointF(2.5, 2.5));
    painter.drawLine(centre + QPointF(-2.5, 2.5), centre + QPointF(2.5, -2.5));
}

/// A small disc at the lower right of a waypoint: the shape that goes with the colour.
void paintBadge(QPainter& painter, const QPointF& disc, VisitState state, const Theme& theme) {
    if (state != VisitState::Done && state != VisitState::Failed) return;
    const QPointF centre = disc + QPointF(0.75, 0.75) * kWaypointDisc_px;
    const bool done = state == VisitState::Done;
    painter.setPen(QPen(theme.surface0, 1.0));
    painter.setBrush(done ? theme.clear : theme.finding);
    painter.drawEllipse(centre, 5.5, 5.5);
    const QColor ink = done ? theme.surface0 : theme.onFinding;
    done ? paintTick(painter, centre, ink) : paintCross(painter, centre, ink);
}

}  // namespace

StatusKind statusOf(VisitState state) {
    switch (state) {
        case VisitState::Draft:
            return StatusKind::ToDo;
        case VisitState::Sent:
        case VisitState::Accepted:
        case VisitState::Driving:
        case VisitState::Arrived:
        case VisitState::Photo:
            return StatusKind::Running;
        case VisitState::Done:
            return StatusKind::Clear;
        case VisitState::Failed:
            return StatusKind::Finding;
        case VisitState::Skipped:
            return StatusKind::Attention;
    }
    return StatusKind::Neutral;
}

void paintCandidateSign(QPainter& painter, const CandidateSign& sign, const Theme& theme) {
    if (sign.selected) {
        painter.setPen(QPen(theme.accent, 2.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(sign.centre, sign.radius_px + 4.0, sign.radius_px + 4.0);
    }
    QColor fill = sign.colour;
    fill.setAlpha(sign.verdict == Verdict::Finding ? 190 : 50);
    // A dark and a light line together show on walls as well as on free floor.
    painter.setBrush(fill);
    painter.setPen(QPen(theme.surface0, 4.0));
    painter.drawEllipse(sign.centre, sign.radius_px, sign.radius_px);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(sign.colour, 2.0, sign.hasNoWaypoint ? Qt::DotLine : Qt::SolidLine));
    painter.drawEllipse(sign.centre, sign.radius_px, sign.radius_px);
    if (sign.verdict == Verdict::NoFod) {
        const QPointF across = QPointF(0.7, -0.7) * sign.radius_px;
        painter.drawLine(sign.centre - across, sign.centre + across);
    }
}

void paintPlate(QPainter& painter, const QRectF& place, const QString& text, const QColor& colour, const Theme& theme) {
    QColor plate = theme.surface0;
    plate.setAlpha(225);
    painter.setPen(Qt::NoPen);
    painter.setBrush(plate);
    painter.drawRoundedRect(place, 3.0, 3.0);
    painter.setPen(colour);
    painter.drawText(place, Qt::AlignCenter, text);
}

void paintLeaderLabel(QPainter& painter, const QPointF& mark, double radius_px, const QRectF& place,
                      const QString& text, const QColor& colour, bool selected, const Theme& theme) {
    const QPointF middle = place.center();
    const double angle_rad = std::atan2(-(middle.y() - mark.y()), middle.x() - mark.x());
    const QPointF end(std::clamp(mark.x(), place.left(), place.right()),
                      std::clamp(mark.y(), place.top(), place.bottom()));
    painter.setPen(QPen(colour, 1.2));
    painter.drawLine(towards(mark, angle_rad, radius_px), end);
    paintPlate(painter, place, text, theme.text, theme);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(selected ? theme.accent : colour, selected ? 2.0 : 1.0));
    painter.drawRoundedRect(place, 3.0, 3.0);
}

void paintWaypointSign(QPainter& painter, const QPointF& centre, const QString& number, VisitState state, bool selected,
                       bool hovered, const Theme& theme) {
    const bool underWay = statusOf(state) == StatusKind::Running;
    const QColor border = state == VisitState::Failed ? theme.finding
                          : state == VisitState::Done ? theme.clear
                                                      : theme.text;
    painter.setBrush(underWay ? theme.text : theme.surface1);
    painter.setPen(QPen(border, hovered ? 2.5 : 1.5, state == VisitState::Skipped ? Qt::DotLine : Qt::SolidLine));
    painter.drawEllipse(centre, kWaypointDisc_px, kWaypointDisc_px);
    if (selected) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(theme.accent, 2.0));
        painter.drawEllipse(centre, kWaypointDisc_px + 3.0, kWaypointDisc_px + 3.0);
    }
    painter.setPen(underWay ? theme.surface0 : state == VisitState::Skipped ? theme.muted : theme.text);
    painter.drawText(QRectF(centre - QPointF(14, 10), QSizeF(28, 20)), Qt::AlignCenter, number);
    paintBadge(painter, centre, state, theme);
}

void paintViewCone(QPainter& painter, const QPointF& apex, double range_px, double yaw_rad, double angle_rad,
                   const QColor& fill) {
    QPainterPath path(apex);
    const QRectF circle(apex - QPointF(range_px, range_px), QSizeF(2 * range_px, 2 * range_px));
    path.arcTo(circle, degreesFromRadians(yaw_rad - 0.5 * angle_rad), degreesFromRadians(angle_rad));
    path.closeSubpath();
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawPath(path);
}

void paintRobotSign(QPainter& painter, const QPointF& place, double radius_px, double yaw_rad, bool stale,
                    const Theme& theme) {
    const QColor colour = stale ? theme.muted : theme.clear;
    QColor fill = colour;
    fill.setAlpha(stale ? 40 : 70);
    painter.setPen(QPen(colour, 2.0, stale ? Qt::DashLine : Qt::SolidLine));
    painter.setBrush(fill);
    painter.drawEllipse(place, radius_px, radius_px);
    painter.setPen(QPen(theme.surface0, 1.0));
    painter.setBrush(colour);
    painter.drawPolygon(QPolygonF(QVector<QPointF>{
        towards(place, yaw_rad, 0.95 * radius_px), towards(place, yaw_rad + 2.5, 0.75 * radius_px),
        towards(place, yaw_rad + M_PI, 0.3 * radius_px), towards(place, yaw_rad - 2.5, 0.75 * radius_px)}));
}

void paintStartSign(QPainter& painter, const QPointF& centre, const Theme& theme) {
    painter.setPen(QPen(theme.muted, 1.5));
    painter.setBrush(theme.surface0);
    painter.drawRect(QRectF(centre - QPointF(4, 4), QSizeF(8, 8)));
}

}  // namespace fodscope
