// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>

namespace fodscope {

/// A rigid motion in metres. `T_a_from_b` takes a point in frame b to the same point in frame a.
using Transform = Eigen::Isometry3d;

/// A robot pose in the plane of the floor, in the frame its name tells (x forward at yaw 0, REP 103).
struct Pose2 {
    double x_m = 0.0;
    double y_m = 0.0;
    double yaw_rad = 0.0;

    bool operator==(const Pose2&) const = default;
};

/// @return the pose as a transform with z = 0 and no roll or pitch
Transform transformFromPose(const Pose2& pose);

/// @return the planar part of a transform (z, roll and pitch are dropped)
Pose2 poseFromTransform(const Transform& transform);

/// @return the angle in (−π, π]
double wrapAngle(double angle_rad);

/// @param rows 16 numbers, row-major, as files and JSON hold them
/// @param subject where they come from, for the error
/// @throws Error when a number is not finite, the last row is not 0 0 0 1 or the rotation is not a rotation (1e-3)
Transform transformFromRows(const std::array<double, 16>& rows, const std::string& subject);

/// @return 16 numbers, row-major
std::array<double, 16> rowsFromTransform(const Transform& transform);

inline constexpr double kDegreesPerRadian = 57.29577951308232;
inline double degreesFromRadians(double angle_rad) {
    return angle_rad * kDegreesPerRadian;
}
inline double radiansFromDegrees(double angle_deg) {
    return angle_deg / kDegreesPerRadian;
}

}  // namespace fodscope
