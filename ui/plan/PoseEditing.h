// SPDX-License-Identifier: MIT
#pragma once

#include <QPainter>
#include <optional>

#include "ui/plan/PlanGeometry.h"
#include "ui/theme/Theme.h"

namespace fodscope {

/// What the mouse holds of a pose: the pose itself, or the handle that turns it.
struct PoseGrip {
    std::size_t waypoint = 0;
    bool turns = false;
};

/// Length of the arm between a pose and the handle that turns it.
inline constexpr double kTurnArm_px = 26.0;

/// @return what is under the mouse; a handle before a pose, a later one before an earlier one
std::optional<PoseGrip> poseGripAt(const PlanScene& scene, const PlanTransform& transform, const QPointF& point);

/// @return the pose as it is while the mouse drags the grip to a point
Pose2 draggedPose(const PoseGrip& grip, const Pose2& pose_map, const PlanTransform& transform, const QPointF& point);

/// @return a pose at a place that looks on from the route's last one; along x for the first
Pose2 addedPose(const PlanScene& scene, const Eigen::Vector2d& place_map);

/// The line from pose to pose, and the arms that turn them.
void paintPoseHandles(QPainter& painter, const PlanScene& scene, const PlanTransform& transform, const Theme& theme);

}  // namespace fodscope
