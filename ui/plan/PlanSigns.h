// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QPointF>
#include <QRectF>
#include <QString>

#include "core/labels/Decision.h"
#include "core/robot/Visit.h"
#include "ui/theme/Theme.h"

QT_BEGIN_NAMESPACE
class QPainter;
QT_END_NAMESPACE

namespace fodscope {

/// The signs of the plan; plan and legend draw the same ones.

struct CandidateSign {
    QPointF centre;
    double radius_px = 7.0;
    QColor colour;
    Verdict verdict = Verdict::NotPhotographed;
    bool selected = false;
    bool hasNoWaypoint = false;
};

/// A ring in the candidate's colour; filled once it is a finding, with a bar through it when decided no FOD, dashed
/// when no waypoint photographs it.
void paintCandidateSign(QPainter& painter, const CandidateSign& sign, const Theme& theme);

/// A line from a mark to its label, and the label.
void paintLeaderLabel(QPainter& painter, const QPointF& mark, double radius_px, const QRectF& place,
                      const QString& text, const QColor& colour, bool selected, const Theme& theme);

/// Words on a plate that keeps them readable over anything.
void paintPlate(QPainter& painter, const QRectF& place, const QString& text, const QColor& colour, const Theme& theme);

/// A numbered disc: empty to do, filled under way, ticked done, crossed failed, dashed skipped.
void paintWaypointSign(QPainter& painter, const QPointF& centre, const QString& number, VisitState state, bool selected,
                       bool hovered, const Theme& theme);

void paintViewCone(QPainter& painter, const QPointF& apex, double range_px, double yaw_rad, double angle_rad,
                   const QColor& fill);

void paintRobotSign(QPainter& painter, const QPointF& place, double radius_px, double yaw_rad, bool stale,
                    const Theme& theme);

/// Where the robot set out.
void paintStartSign(QPainter& painter, const QPointF& centre, const Theme& theme);

/// @return colour and word of a visit's state
StatusKind statusOf(VisitState state);

}  // namespace fodscope
