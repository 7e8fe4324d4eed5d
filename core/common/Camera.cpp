// SPDX-License-Identifier: MIT
#include "core/common/Camera.h"

#include <cmath>

namespace fodscope {

CameraIntrinsics intrinsicsOf(const CameraSettings& settings) {
    const double focal_px = 0.5 * settings.width_px / std::tan(0.5 * settings.horizontalFieldOfView_rad);
    return {settings.width_px, settings.height_px,      focal_px,
            focal_px,          0.5 * settings.width_px, 0.5 * settings.height_px};
}

Transform cameraPose(const Pose2& robot, const CameraSettings& settings) {
    Transform T_robot_from_camera = Transform::Identity();
    const double c = std::cos(settings.pitchDown_rad), s = std::sin(settings.pitchDown_rad);
    // Columns: image right, image down and forward in the robot's frame (x forward, y left, z up).
    T_robot_from_camera.linear().col(0) = Eigen::Vector3d(0.0, -1.0, 0.0);
    T_robot_from_camera.linear().col(1) = Eigen::Vector3d(-s, 0.0, -c);
    T_robot_from_camera.linear().col(2) = Eigen::Vector3d(c, 0.0, -s);
    T_robot_from_camera.translation() = Eigen::Vector3d(0.0, 0.0, settings.height_m);
    return transformFromPose(robot) * T_robot_from_camera;
}

}  // namespace fodscope
