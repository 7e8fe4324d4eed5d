// SPDX-License-Identifier: MIT
#include "core/simulation/DriveMotion.h"

#include <gtest/gtest.h>

#include <numbers>

namespace fodscope {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(DriveMotion, turnsDrivesAndTurnsAgain) {
    const DrivePath path{{{0.0, 0.0}, {0.0, 2.0}}, 2.0};
    const DriveMotion motion({0.0, 0.0, 0.0}, path, {0.0, 2.0, kPi}, 0.5, 1.0);
    // A quarter turn, 2 m at 0.5 m/s, a quarter turn.
    EXPECT_NEAR(motion.duration_s(), kPi / 2.0 + 4.0 + kPi / 2.0, 1e-12);
    EXPECT_NEAR(motion.poseAt(0.5).yaw_rad, 0.5, 1e-12);
    EXPECT_NEAR(motion.poseAt(kPi / 2.0 + 1.0).y_m, 0.5, 1e-12);
    EXPECT_NEAR(motion.distanceLeftAt(kPi / 2.0 + 1.0), 1.5, 1e-12);
    EXPECT_EQ(motion.poseAt(1e9), (Pose2{0.0, 2.0, kPi}));
    EXPECT_EQ(motion.poseAt(-1.0), (Pose2{0.0, 0.0, 0.0}));
    EXPECT_EQ(motion.distanceLeftAt(1e9), 0.0);
}

TEST(DriveMotion, takesTheShorterTurn) {
    const DrivePath path{{{0.0, 0.0}}, 0.0};
    const DriveMotion motion({0.0, 0.0, 0.9 * kPi}, path, {0.0, 0.0, -0.9 * kPi}, 0.5, 1.0);
    EXPECT_NEAR(motion.duration_s(), 0.2 * kPi, 1e-12);
    EXPECT_GT(std::abs(motion.poseAt(0.3).yaw_rad), 0.9 * kPi);
}

TEST(DriveMotion, standingStillTakesNoTime) {
    const DrivePath path{{{1.0, 1.0}, {1.0, 1.0}}, 0.0};
    const DriveMotion motion({1.0, 1.0, 0.3}, path, {1.0, 1.0, 0.3}, 0.5, 1.0);
    EXPECT_EQ(motion.duration_s(), 0.0);
    EXPECT_EQ(motion.poseAt(0.0), (Pose2{1.0, 1.0, 0.3}));
}

}  // namespace
}  // namespace fodscope
