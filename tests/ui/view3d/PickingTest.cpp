// SPDX-License-Identifier: MIT
#include "ui/view3d/Picking.h"

#include <gtest/gtest.h>

#include <vector>

#include "ui/view3d/PointLayer.h"

namespace fodscope {
namespace {

OrbitCamera fromAbove(double distance_m) {
    OrbitCamera camera;
    camera.azimuth_rad = -1.57079632679489661923;
    camera.elevation_rad = 1.57079632679489661923;
    camera.distance_m = distance_m;
    return camera;
}

TEST(Picking, UnprojectUndoesProject) {
    for (const bool parallel : {false, true}) {
        OrbitCamera camera;
        camera.parallel = parallel;
        const ScreenProjection screen(camera, 640, 480);
        const Eigen::Vector3d point(0.7, -1.1, 0.3);
        const auto spot = screen.project(point);
        EXPECT_TRUE(screen.unproject(spot->x_px, spot->y_px, spot->depth_m).isApprox(point, 1e-9));
    }
}

TEST(Picking, PointsBehindTheEyeAreNotOnTheScreen) {
    const ScreenProjection screen(fromAbove(5.0), 640, 480);
    EXPECT_FALSE(screen.project(Eigen::Vector3d(0.0, 0.0, 6.0)).has_value());
}

TEST(Picking, TakesTheForemostOfPointsBehindEachOther) {
    const std::vector<Eigen::Vector3f> points = {{0, 0, -1}, {0, 0, 1}, {0, 0, 0}};
    const auto hit = pickNearest(points, ScreenProjection(fromAbove(5.0), 640, 480), 320, 240, 6, std::nullopt);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->index, 1U);
    EXPECT_NEAR(hit->depth_m, 4.0, 1e-6);
}

TEST(Picking, TakesThePointUnderThePointerOnASurface) {
    std::vector<Eigen::Vector3f> points;
    for (int i = -50; i <= 50; ++i)
        points.emplace_back(0.01F * static_cast<float>(i), 0.0F, 0.0F);
    const ScreenProjection screen(fromAbove(5.0), 640, 480);
    const auto wanted = screen.project(points[73].cast<double>());
    const auto hit = pickNearest(points, screen, wanted->x_px, wanted->y_px, 8, std::nullopt);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->index, 73U);
}

TEST(Picking, PeeledPointsAreNotThere) {
    const std::vector<Eigen::Vector3f> points = {{0, 0, 2}, {0, 0, 0}};
    const auto hit = pickNearest(points, ScreenProjection(fromAbove(5.0), 640, 480), 320, 240, 6, 1.0);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->index, 1U);
}

TEST(Picking, FindsNothingBesideThePoints) {
    const std::vector<Eigen::Vector3f> points = {{0, 0, 0}};
    EXPECT_FALSE(pickNearest(points, ScreenProjection(fromAbove(5.0), 640, 480), 350, 240, 6, std::nullopt));
}

TEST(Picking, SpacingOfAGridIsItsStep) {
    std::vector<Eigen::Vector3f> points;
    for (int x = 0; x < 40; ++x) {
        for (int y = 0; y < 40; ++y)
            points.emplace_back(0.05F * static_cast<float>(x), 0.05F * static_cast<float>(y), 0);
    }
    EXPECT_NEAR(typicalSpacing(points), 0.05, 1e-5);
    EXPECT_EQ(typicalSpacing({}), 0.0);
}

}  // namespace
}  // namespace fodscope
