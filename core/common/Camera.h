// SPDX-License-Identifier: MIT
#pragma once

#include "core/common/Geometry.h"

namespace fodscope {

/// A pinhole without distortion, pixels.
struct CameraIntrinsics {
    int width_px = 0;
    int height_px = 0;
    double fx_px = 0.0;
    double fy_px = 0.0;
    double cx_px = 0.0;
    double cy_px = 0.0;

    bool operator==(const CameraIntrinsics&) const = default;
};

/// The robot's photo camera and where it sits: over the middle of the robot, looking forward. Planning, the simulated
/// robot and what shows a view in advance all rest on this one description.
struct CameraSettings {
    int width_px = 1280;
    int height_px = 720;
    double horizontalFieldOfView_rad = radiansFromDegrees(69.0);
    /// Of the lens over the floor.
    double height_m = 0.20;
    double pitchDown_rad = radiansFromDegrees(5.0);
    /// What is nearer to the lens is out of focus.
    double nearLimit_m = 0.15;

    bool operator==(const CameraSettings&) const = default;
};

CameraIntrinsics intrinsicsOf(const CameraSettings& settings);

/// @return the camera's optical frame (z forward, x right, y down) for a robot standing at `robot`, in the robot's
///         frame of reference with the floor at z = 0
Transform cameraPose(const Pose2& robot, const CameraSettings& settings);

/// Pinhole projection of a point before the camera (z > 0).
inline Eigen::Vector2d pixelOf(const Eigen::Vector3d& point_camera, const CameraIntrinsics& k) {
    return {k.fx_px * point_camera.x() / point_camera.z() + k.cx_px,
            k.fy_px * point_camera.y() / point_camera.z() + k.cy_px};
}

inline bool isInImage(const Eigen::Vector2d& pixel, const CameraIntrinsics& k) {
    return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() < k.width_px && pixel.y() < k.height_px;
}

}  // namespace fodscope
