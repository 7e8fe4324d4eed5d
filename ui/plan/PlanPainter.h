// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>
#include <QString>
#include <optional>
#include <vector>

#include "ui/plan/PlanGeometry.h"
#include "ui/plan/PlanScene.h"
#include "ui/theme/Theme.h"

QT_BEGIN_NAMESPACE
class QPainter;
QT_END_NAMESPACE

namespace fodscope {

/// The cost map as images of its cells, one pixel a cell, row 0 on top: made once for a scene and a theme.
struct PlanImages {
    /// Free, occupied, inflation shading; transparent where unknown.
    QImage cells;
    /// Opaque where not observed.
    QImage unknown;
    /// Opaque where a robot would fit but does not get to.
    QImage unreachable;
    /// Cells a pixel: grids of more than 4096 cells an edge are drawn coarser, images for print finer.
    double cellsPerPixel = 1.0;
};

PlanImages planImages(const PlanScene& scene, const Theme& theme);

/// The same with more pixels a cell: viewers of PDF smooth images, which then shows on the edges of the cells only.
PlanImages forPrint(const PlanImages& images);

/// Colour of the hatching over what is not observed, or is out of reach.
QColor hatchColour(const Theme& theme, bool unreachable);

/// How the plan is drawn, beside its content.
struct PlanLook {
    Theme theme;
    std::optional<PlanRobot> robot;
    std::string selectedCandidate;
    std::string selectedWaypoint;
    std::string hovered;
    /// Waypoints, route and cones; the report's plan of candidates has none before a visit.
    bool showVisits = true;
    double fontPixels = 12.0;
};

/// Poses older than this are shown as stale.
inline constexpr double kStalePose_s = 2.0;

void paintPlan(QPainter& painter, const QRectF& area, const PlanScene& scene, const PlanImages& images,
               const PlanTransform& transform, const PlanLook& look);

/// What the signs mean, only those that the scene has, in rows as wide as the area.
/// @param paint false: only measures
/// @return the height that the rows take
double paintPlanLegend(QPainter& painter, const QRectF& area, const PlanScene& scene, const PlanLook& look, bool paint);

/// A plan by itself, such as a page of the report shows: light, with legend and scale bar.
/// @param selectedCandidate marked; empty for none
QImage planImage(const PlanScene& scene, const QSize& size_px, ThemeKind theme,
                 const std::string& selectedCandidate = {});

}  // namespace fodscope
