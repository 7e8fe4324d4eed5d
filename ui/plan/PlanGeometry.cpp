// SPDX-License-Identifier: MIT
#include "ui/plan/PlanGeometry.h"

#include <QLineF>
#include <QObject>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fodscope {

namespace {

constexpr double kMargin_px = 24.0;
constexpr double kFewestPixels = 5.0;
constexpr double kMostPixels = 5000.0;
constexpr double kSmallestRing_px = 7.0;

void addCells(const OccupancyGrid& grid, bool onlyKnown, PlanExtent& extent) {
    int left = grid.width, right = -1, bottom = grid.height, top = -1;
    for (int row = 0; row < grid.height; ++row) {
        for (int column = 0; column < grid.width; ++column) {
            if (onlyKnown && grid.at({column, row}) == Cell::Unknown) continue;
            left = std::min(left, column);
            right = std::max(right, column);
            bottom = std::min(bottom, row);
            top = std::max(top, row);
        }
    }
    if (right < left) return;
    const Eigen::Rotation2Dd turn(grid.origin_map.yaw_rad);
    for (const int column : {left, right + 1}) {
        for (const int row : {bottom, top + 1}) {
            extent.add(Eigen::Vector2d(grid.origin_map.x_m, grid.origin_map.y_m) +
                       turn * Eigen::Vector2d(column * grid.resolution_m, row * grid.resolution_m));
        }
    }
}

}  // namespace

void PlanExtent::add(const Eigen::Vector2d& point_map) {
    minimum_map = empty ? point_map : minimum_map.cwiseMin(point_map).eval();
    maximum_map = empty ? point_map : maximum_map.cwiseMax(point_map).eval();
    empty = false;
}

PlanExtent planExtent(const PlanScene& scene) {
    PlanExtent extent;
    if (scene.costMap) {
        addCells(scene.costMap->grid, true, extent);
        if (extent.empty) addCells(scene.costMap->grid, false, extent);
    }
    for (const Eigen::Vector2d& point : scene.pointsFromAbove_map)
        extent.add(point);
    for (const PlanCandidate& candidate : scene.candidates)
        extent.add(candidate.centroid_map);
    for (const PlanWaypoint& waypoint : scene.waypoints)
        extent.add({waypoint.pose_map.x_m, waypoint.pose_map.y_m});
    return extent;
}

PlanTransform fittedPlan(const PlanExtent& extent, const QRectF& area) {
    PlanTransform transform;
    transform.origin = area.center();
    if (extent.empty) return transform;
    constexpr double kSmallest_m = 0.5;
    const Eigen::Vector2d size = (extent.maximum_map - extent.minimum_map).cwiseMax(kSmallest_m);
    const double width = std::max(10.0, area.width() - 2.0 * kMargin_px);
    const double height = std::max(10.0, area.height() - 2.0 * kMargin_px);
    transform.pixelsPerMetre = std::clamp(std::min(width / size.x(), height / size.y()), kFewestPixels, kMostPixels);
    const Eigen::Vector2d middle = 0.5 * (extent.minimum_map + extent.maximum_map);
    transform.origin = area.center() - QPointF(middle.x(), -middle.y()) * transform.pixelsPerMetre;
    return transform;
}

PlanTransform zoomedPlan(const PlanTransform& transform, double factor, const QPointF& anchor) {
    const Eigen::Vector2d kept = transform.toMap(anchor);
    PlanTransform zoomed;
    zoomed.pixelsPerMetre = std::clamp(transform.pixelsPerMetre * factor, kFewestPixels, kMostPixels);
    zoomed.origin = anchor - QPointF(kept.x(), -kept.y()) * zoomed.pixelsPerMetre;
    return zoomed;
}

QTransform gridToScreen(const OccupancyGrid& grid, const PlanTransform& transform) {
    const double scale = grid.resolution_m * transform.pixelsPerMetre;
    const double cosine = std::cos(grid.origin_map.yaw_rad);
    const double sine = std::sin(grid.origin_map.yaw_rad);
    const QPointF corner = transform.toScreen({grid.origin_map.x_m, grid.origin_map.y_m});
    // Columns of the rotation times scale; the screen's y points down.
    return {scale * cosine, -scale * sine, -scale * sine, -scale * cosine, corner.x(), corner.y()};
}

std::vector<QPointF> discCentres(const PlanScene& scene, const PlanTransform& transform) {
    constexpr double kApart_px = 2.0 * kWaypointDisc_px - 2.0;
    constexpr int kDirections = 12;
    std::vector<QPointF> centres;
    const auto isFree = [&](const QPointF& place) {
        return std::all_of(centres.begin(), centres.end(),
                           [&](const QPointF& other) { return QLineF(place, other).length() >= kApart_px; });
    };
    for (const PlanWaypoint& waypoint : scene.waypoints) {
        const QPointF pose = transform.toScreen({waypoint.pose_map.x_m, waypoint.pose_map.y_m});
        QPointF place = pose;
        for (int step = 0; step < 3 * kDirections && !isFree(place); ++step) {
            // Behind the robot first: the view cone in front stays open.
            const int side = step % kDirections;
            const double turn_rad = (side + 1) / 2 * (side % 2 ? 1.0 : -1.0) * 2.0 * M_PI / kDirections;
            const double angle_rad = waypoint.pose_map.yaw_rad + M_PI + turn_rad;
            const double distance = kApart_px * (1 + step / kDirections);
            place = pose + QPointF(std::cos(angle_rad), -std::sin(angle_rad)) * distance;
        }
        centres.push_back(place);
    }
    return centres;
}

double candidateRing_px(const PlanCandidate& candidate, const PlanTransform& transform) {
    return std::max(kSmallestRing_px, candidate.radius_m * transform.pixelsPerMetre + 2.0);
}

PlanHit planHit(const PlanScene& scene, const PlanTransform& transform, const QPointF& point, double reach_px) {
    PlanHit hit;
    double nearest = std::numeric_limits<double>::max();
    const std::vector<QPointF> discs = discCentres(scene, transform);
    for (std::size_t index = 0; index < discs.size(); ++index) {
        const double distance = QLineF(discs[index], point).length();
        if (distance > kWaypointDisc_px + 1.0 || distance >= nearest) continue;
        nearest = distance;
        hit = {PlanItem::Waypoint, scene.waypoints[index].id};
    }
    if (hit.item != PlanItem::None) return hit;
    for (const PlanCandidate& candidate : scene.candidates) {
        const double distance = QLineF(transform.toScreen(candidate.centroid_map), point).length();
        if (distance > candidateRing_px(candidate, transform) + reach_px || distance >= nearest) continue;
        nearest = distance;
        hit = {PlanItem::Candidate, candidate.id};
    }
    return hit;
}

double facingFrom(const PlanScene& scene, const PlanWaypoint& waypoint, const Eigen::Vector2d& place_map) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    int count = 0;
    for (const PlanCandidate& candidate : scene.candidates) {
        const auto& ids = waypoint.candidateIds;
        if (std::find(ids.begin(), ids.end(), candidate.id) == ids.end()) continue;
        sum += candidate.centroid_map;
        ++count;
    }
    if (count == 0) return waypoint.pose_map.yaw_rad;
    const Eigen::Vector2d way = sum / count - place_map;
    return std::atan2(way.y(), way.x());
}

double scaleBarLength(double pixelsPerMetre, double widest_px) {
    const double widest_m = widest_px / pixelsPerMetre;
    const double decade = std::pow(10.0, std::floor(std::log10(widest_m)));
    for (const double step : {5.0, 2.0}) {
        // A hair of tolerance, so that exactly 1, 2 or 5 is not lost to rounding.
        if (step * decade <= widest_m * (1.0 + 1e-9)) return step * decade;
    }
    return decade;
}

QString lengthInWords(double length_m) {
    if (length_m < 0.995) return QObject::tr("%1 cm").arg(length_m * 100.0, 0, 'g', 3);
    return QObject::tr("%1 m").arg(length_m, 0, 'g', 3);
}

QRectF placeLabel(const QPointF& mark, double markRadius_px, const QSizeF& size, const std::vector<QRectF>& taken,
                  const QRectF& area) {
    const auto at = [&](double angle_rad, double gap_px) {
        const QPointF direction(std::cos(angle_rad), -std::sin(angle_rad));
        const QPointF centre = mark + QPointF(direction.x() * (markRadius_px + gap_px + 0.5 * size.width()),
                                              direction.y() * (markRadius_px + gap_px + 0.5 * size.height()));
        return QRectF(centre - QPointF(0.5 * size.width(), 0.5 * size.height()), size);
    };
    const auto isFree = [&](const QRectF& place) {
        return area.contains(place) &&
               std::none_of(taken.begin(), taken.end(), [&](const QRectF& other) { return other.intersects(place); });
    };
    constexpr std::array<double, 8> kAngles_deg{35, -35, 145, -145, 0, 180, 90, -90};
    for (const double gap_px : {6.0, 18.0, 34.0}) {
        for (const double angle_deg : kAngles_deg) {
            const QRectF place = at(radiansFromDegrees(angle_deg), gap_px);
            if (isFree(place)) return place;
        }
    }
    return at(radiansFromDegrees(kAngles_deg.front()), 6.0);
}

}  // namespace fodscope
