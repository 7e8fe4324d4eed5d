// SPDX-License-Identifier: MIT
#include "ui/plan/PoseEditing.h"

#include <cmath>

namespace fodscope {
namespace {

constexpr double kHandle_px = 5.0;
constexpr double kReach_px = 4.0;

QPointF handleOf(const Pose2& pose_map, const PlanTransform& transform) {
    return transform.toScreen({pose_map.x_m, pose_map.y_m}) +
           kTurnArm_px * QPointF(std::cos(pose_map.yaw_rad), -std::sin(pose_map.yaw_rad));
}

double distance(const QPointF& a, const QPointF& b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

}  // namespace

std::optional<PoseGrip> poseGripAt(const PlanScene& scene, const PlanTransform& transform, const QPointF& point) {
    for (const bool turns : {true, false}) {
        for (std::size_t i = scene.waypoints.size(); i-- > 0;) {
            const Pose2& pose = scene.waypoints[i].pose_map;
            const QPointF grip = turns ? handleOf(pose, transform) : transform.toScreen({pose.x_m, pose.y_m});
            const double reach_px = kReach_px + (turns ? kHandle_px : kWaypointDisc_px);
            if (distance(grip, point) <= reach_px) return PoseGrip{i, turns};
        }
    }
    return std::nullopt;
}

Pose2 draggedPose(const PoseGrip& grip, const Pose2& pose_map, const PlanTransform& transform, const QPointF& point) {
    const Eigen::Vector2d place_map = transform.toMap(point);
    if (!grip.turns) return {place_map.x(), place_map.y(), pose_map.yaw_rad};
    const double dx = place_map.x() - pose_map.x_m;
    const double dy = place_map.y() - pose_map.y_m;
    // On the pose itself there is no direction to turn to.
    return std::hypot(dx, dy) < 1e-6 ? pose_map : Pose2{pose_map.x_m, pose_map.y_m, std::atan2(dy, dx)};
}

Pose2 addedPose(const PlanScene& scene, const Eigen::Vector2d& place_map) {
    Pose2 pose{place_map.x(), place_map.y(), 0.0};
    if (scene.waypoints.empty()) return pose;
    const Pose2& last = scene.waypoints.back().pose_map;
    pose.yaw_rad = std::atan2(pose.y_m - last.y_m, pose.x_m - last.x_m);
    return pose;
}

void paintPoseHandles(QPainter& painter, const PlanScene& scene, const PlanTransform& transform, const Theme& theme) {
    QPolygonF line;
    for (const PlanWaypoint& waypoint : scene.waypoints)
        line << transform.toScreen({waypoint.pose_map.x_m, waypoint.pose_map.y_m});
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.muted, 1.5, Qt::DashLine));
    painter.drawPolyline(line);
    for (int i = 0; i < line.size(); ++i) {
        const Pose2& pose = scene.waypoints[static_cast<std::size_t>(i)].pose_map;
        const QPointF handle = handleOf(pose, transform);
        const QPointF direction(std::cos(pose.yaw_rad), -std::sin(pose.yaw_rad));
        painter.setPen(QPen(theme.text, 2.0));
        painter.drawLine(line[i] + kWaypointDisc_px * direction, handle);
        painter.setBrush(theme.surface1);
        painter.drawEllipse(handle, kHandle_px, kHandle_px);
    }
}

}  // namespace fodscope
