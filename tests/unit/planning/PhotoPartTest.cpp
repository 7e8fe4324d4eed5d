// SPDX-License-Identifier: MIT
#include "core/planning/PhotoPart.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fodscope {
namespace {

PhotoPart box(double length_m, double width_m, double height_m, double direction_rad = 0.0) {
    return wholeOf({"C-001", {1.0, 2.0, 0.5 * height_m}, {length_m, width_m, height_m}, direction_rad, {}, 0.02}, 3);
}

TEST(PhotoPart, aTargetWithoutVoxelsIsTheBoxOfItsSize) {
    const PhotoPart part = box(0.4, 0.2, 0.1);
    EXPECT_EQ(part.target, 3U);
    EXPECT_NEAR(part.width_m, 0.2, 1e-12);
    EXPECT_NEAR(part.low_m, 0.0, 1e-12);
    EXPECT_NEAR(part.high_m, 0.1, 1e-12);
    EXPECT_NEAR(distanceTo(part, {1.5, 2.0}), 0.3, 1e-12);
    EXPECT_NEAR(distanceTo(part, {1.0, 1.5}), 0.4, 1e-12);
    EXPECT_NEAR(distanceTo(part, {1.2 + 0.3, 2.1 + 0.4}), 0.5, 1e-12);
    EXPECT_EQ(distanceTo(part, {1.1, 2.05}), 0.0);
    EXPECT_NEAR(distanceTo(box(0.4, 0.2, 0.1, 3.14159265358979 / 2), {1.0, 2.5}), 0.3, 1e-9);
}

TEST(PhotoPart, placesLieAtTheirDistanceFromTheEdgeInEveryDirection) {
    const PhotoPart part = box(1.4, 0.1, 0.3, 0.4);
    for (int step = 0; step < 36; ++step) {
        const Eigen::Vector2d direction(std::cos(step * 0.17), std::sin(step * 0.17));
        const Eigen::Vector2d place = placeBeside(part, direction, 0.6);
        EXPECT_NEAR(distanceTo(part, place), 0.6, 1e-9);
        EXPECT_NEAR((place - part.centre_map).normalized().dot(direction), 1.0, 1e-9);
    }
}

TEST(PhotoPart, isHalvedAcrossItsLongestExtentWithoutLosingAVoxel) {
    const PhotoPart part = box(1.0, 0.1, 0.3, 0.7);
    const auto halves = halvesOf(part);
    ASSERT_TRUE(halves);
    EXPECT_EQ(halves->first.voxels.size() + halves->second.voxels.size(), part.voxels.size());
    EXPECT_EQ(halves->first.target, 3U);
    EXPECT_NEAR((halves->first.centre_map - halves->second.centre_map).norm(), 0.5, 0.03);
    const auto upright = halvesOf(box(0.1, 0.1, 1.0));
    ASSERT_TRUE(upright);
    EXPECT_LT(std::min(upright->first.high_m, upright->second.high_m), 0.6);
    EXPECT_FALSE(halvesOf(box(0.28, 0.1, 0.1)));
}

TEST(PhotoPart, standsInTheWayOfLooksThatMeetItAndNoOthers) {
    const PhotoPart part = box(0.4, 0.2, 0.1);
    EXPECT_TRUE(isInTheWay(part, {0.0, 2.0, 0.05}, {2.0, 2.0, 0.05}));
    EXPECT_FALSE(isInTheWay(part, {0.0, 2.0, 0.2}, {2.0, 2.0, 0.2})) << "over it";
    EXPECT_TRUE(isInTheWay(part, {0.0, 2.0, 0.2}, {2.0, 2.0, 0.0})) << "down through it";
    EXPECT_FALSE(isInTheWay(part, {0.0, 1.8, 0.05}, {2.0, 1.8, 0.05})) << "beside it";
    EXPECT_FALSE(isInTheWay(part, {0.0, 2.0, 0.05}, {0.7, 2.0, 0.05})) << "before it";
    EXPECT_FALSE(isInTheWay(part, {1.0, 0.0, 0.05}, {1.0, 1.8, 0.05}));
}

}  // namespace
}  // namespace fodscope
