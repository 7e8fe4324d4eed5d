// SPDX-License-Identifier: MIT
#pragma once

#include <QPointF>
#include <QRectF>
#include <QString>
#include <QTransform>
#include <vector>

#include "ui/plan/PlanScene.h"

namespace fodscope {

/// How the map's plane lies on the screen: x to the right, y up.
struct PlanTransform {
    double pixelsPerMetre = 100.0;
    /// Where the map's origin is.
    QPointF origin;

    QPointF toScreen(const Eigen::Vector2d& point_map) const {
        return {origin.x() + point_map.x() * pixelsPerMetre, origin.y() - point_map.y() * pixelsPerMetre};
    }
    Eigen::Vector2d toMap(const QPointF& point) const {
        return {(point.x() - origin.x()) / pixelsPerMetre, (origin.y() - point.y()) / pixelsPerMetre};
    }
};

/// Rectangle in the map frame, metres.
struct PlanExtent {
    Eigen::Vector2d minimum_map = Eigen::Vector2d::Zero();
    Eigen::Vector2d maximum_map = Eigen::Vector2d::Zero();
    bool empty = true;

    void add(const Eigen::Vector2d& point_map);
    bool operator==(const PlanExtent&) const = default;
};

/// Known cells (all cells when none is known), points, candidates and waypoints.
PlanExtent planExtent(const PlanScene& scene);

/// The extent in the middle of the area, as large as fits.
PlanTransform fittedPlan(const PlanExtent& extent, const QRectF& area);

/// Zooms so that the place under `anchor` stays; 5 px/m to 5000 px/m.
PlanTransform zoomedPlan(const PlanTransform& transform, double factor, const QPointF& anchor);

/// Cells (column, row) to the screen.
QTransform gridToScreen(const OccupancyGrid& grid, const PlanTransform& transform);

inline constexpr double kWaypointDisc_px = 10.0;

/// Centres of the waypoints' discs: on the pose, or beside it when an earlier disc is there.
std::vector<QPointF> discCentres(const PlanScene& scene, const PlanTransform& transform);

/// On-screen radius of a candidate's ring.
double candidateRing_px(const PlanCandidate& candidate, const PlanTransform& transform);

enum class PlanItem { None, Waypoint, Candidate };
struct PlanHit {
    PlanItem item = PlanItem::None;
    std::string id;
};

/// What is under a point: the nearest disc or ring within reach; a waypoint before a candidate.
PlanHit planHit(const PlanScene& scene, const PlanTransform& transform, const QPointF& point, double reach_px = 6.0);

/// @return the yaw with which a waypoint would look at its candidates from a place; as it is when it has none
double facingFrom(const PlanScene& scene, const PlanWaypoint& waypoint, const Eigen::Vector2d& place_map);

/// @return the longest of 1, 2, 5 · 10ⁿ metres that is not longer than `widest_px`
double scaleBarLength(double pixelsPerMetre, double widest_px);

/// @return e.g. "0.5 m", "20 cm"
QString lengthInWords(double length_m);

/// Puts a label of `size` beside a mark so that it meets none of the taken rectangles, if it can.
/// @return its rectangle; it is the caller's to add it to `taken`
QRectF placeLabel(const QPointF& mark, double markRadius_px, const QSizeF& size, const std::vector<QRectF>& taken,
                  const QRectF& area);

}  // namespace fodscope
