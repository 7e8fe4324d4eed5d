// SPDX-License-Identifier: MIT
#include "core/common/Geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/common/Error.h"

using namespace fodscope;

TEST(Geometry, APoseSurvivesTheWayThroughATransform) {
    const Pose2 pose{1.5, -2.0, 2.5};
    const Pose2 back = poseFromTransform(transformFromPose(pose));
    EXPECT_NEAR(back.x_m, pose.x_m, 1e-12);
    EXPECT_NEAR(back.y_m, pose.y_m, 1e-12);
    EXPECT_NEAR(back.yaw_rad, pose.yaw_rad, 1e-12);
}

TEST(Geometry, ATransformTakesPointsFromTheSecondFrameToTheFirst) {
    const Transform T_map_from_robot = transformFromPose({1.0, 2.0, std::numbers::pi / 2});
    const Eigen::Vector3d ahead_map = T_map_from_robot * Eigen::Vector3d(1, 0, 0);
    EXPECT_NEAR((ahead_map - Eigen::Vector3d(1.0, 3.0, 0.0)).norm(), 0.0, 1e-12);
}

TEST(Geometry, AnglesAreWrappedIntoOneTurn) {
    EXPECT_NEAR(wrapAngle(3 * std::numbers::pi / 2), -std::numbers::pi / 2, 1e-12);
    EXPECT_NEAR(wrapAngle(-std::numbers::pi), std::numbers::pi, 1e-12);
}

TEST(Geometry, TransformsThatAreNotRigidAreRefused) {
    const std::array<double, 16> identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    EXPECT_NO_THROW(transformFromRows(identity, "T.csv"));
    auto scaled = identity;
    scaled[0] = 1000.0;
    EXPECT_THROW(transformFromRows(scaled, "T.csv"), Error);
    auto mirrored = identity;
    mirrored[0] = -1.0;
    EXPECT_THROW(transformFromRows(mirrored, "T.csv"), Error);
    auto notANumber = identity;
    notANumber[3] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(transformFromRows(notANumber, "T.csv"), Error);
    auto projective = identity;
    projective[12] = 0.5;
    EXPECT_THROW(transformFromRows(projective, "T.csv"), Error);
}
