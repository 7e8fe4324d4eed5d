// SPDX-License-Identifier: MIT
#include "core/common/Geometry.h"

#include <cmath>
#include <numbers>

#include "core/common/Error.h"

namespace fodscope {

Transform transformFromPose(const Pose2& pose) {
    Transform transform = Transform::Identity();
    transform.translation() = Eigen::Vector3d(pose.x_m, pose.y_m, 0.0);
    transform.linear() = Eigen::AngleAxisd(pose.yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    return transform;
}

Pose2 poseFromTransform(const Transform& transform) {
    const Eigen::Vector3d forward = transform.linear().col(0);
    return {transform.translation().x(), transform.translation().y(), std::atan2(forward.y(), forward.x())};
}

double wrapAngle(double angle_rad) {
    const double wrapped = std::remainder(angle_rad, 2.0 * std::numbers::pi);
    return wrapped <= -std::numbers::pi ? wrapped + 2.0 * std::numbers::pi : wrapped;
}

Transform transformFromRows(const std::array<double, 16>& rows, const std::string& subject) {
    Eigen::Matrix4d matrix;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column)
            matrix(row, column) = rows[static_cast<std::size_t>(row * 4 + column)];
    }
    if (!matrix.allFinite()) {
        throw Error(subject, "the transform holds a number that is not finite", "give 16 finite numbers, row by row");
    }
    if ((matrix.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).cwiseAbs().maxCoeff() > 1e-6) {
        throw Error(subject, "the last row of the transform is not 0 0 0 1", "give a rigid 4x4 transform, row by row");
    }
    const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
    const double departure = (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (departure > 1e-3 || rotation.determinant() < 0.0) {
        throw Error(subject, "the transform is not rigid (its upper left 3x3 is no rotation)",
                    "give a rotation and a translation in metres, without scale or mirror");
    }
    Transform transform = Transform::Identity();
    // The matrix is kept as written: re-orthonormalising would change the last digits that golden values rest on.
    transform.matrix() = matrix;
    return transform;
}

std::array<double, 16> rowsFromTransform(const Transform& transform) {
    std::array<double, 16> rows{};
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column)
            rows[static_cast<std::size_t>(row * 4 + column)] = transform.matrix()(row, column);
    }
    return rows;
}

}  // namespace fodscope
