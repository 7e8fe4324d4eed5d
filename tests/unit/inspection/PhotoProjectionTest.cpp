// SPDX-License-Identifier: MIT
#include "core/common/ConvexHull.h"
#include "core/inspection/PhotoProjection.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fodscope {
namespace {

CameraIntrinsics camera() {
    CameraIntrinsics intrinsics;
    intrinsics.width_px = 640;
    intrinsics.height_px = 480;
    intrinsics.fx_px = 500.0;
    intrinsics.fy_px = 510.0;
    intrinsics.cx_px = 320.0;
    intrinsics.cy_px = 240.0;
    return intrinsics;
}

TEST(ProjectPoints, AKnownPointLandsOnItsPixel) {
    // Camera at (1, 2, 0.5), looking along +x of the map: right is −y, down is −z (REP 103).
    Transform T_map_from_camera = Transform::Identity();
    T_map_from_camera.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    T_map_from_camera.translation() = Eigen::Vector3d(1, 2, 0.5);
    const std::vector<Eigen::Vector3d> points{{3.0, 1.6, 0.7}, {0.0, 2.0, 0.5}};
    const auto pixels = projectPoints(points, T_map_from_camera, camera());
    ASSERT_EQ(pixels.size(), 1U) << "the point behind the camera is left out";
    // 2 m ahead, 0.4 m to the right, 0.2 m up: 320 + 500·0.2 and 240 − 510·0.1.
    EXPECT_NEAR(pixels[0].x(), 420.0, 1e-9);
    EXPECT_NEAR(pixels[0].y(), 189.0, 1e-9);
}

TEST(ConvexHull, KeepsTheCornersOnly) {
    using Points = std::vector<Eigen::Vector2d>;
    const Points hull = convexHull(Points{{0, 0}, {2, 0}, {1, 0}, {2, 2}, {0, 2}, {1, 1}, {0, 0}});
    EXPECT_EQ(hull.size(), 4U);
    for (const Eigen::Vector2d& corner : Points{{0, 0}, {2, 0}, {2, 2}, {0, 2}})
        EXPECT_NE(std::ranges::find(hull, corner), hull.end());
    EXPECT_EQ(convexHull(Points{{1, 1}, {1, 1}}).size(), 1U);
    EXPECT_EQ(convexHull(Points{}).size(), 0U);
}

TEST(ProjectVoxels, TellsTheNearestCornerAndWhichLieInTheImage) {
    // Straight ahead at 2 m; far to the right, outside the image; behind.
    const std::vector<Eigen::Vector3d> voxels{{0, 0, 2}, {5, 0, 3}, {0, 0, -2}};
    const ProjectedVoxels projected = projectVoxels(voxels, 0.2, Transform::Identity(), camera());
    EXPECT_NEAR(projected.nearestDepth_m, 1.9, 1e-12);
    EXPECT_TRUE(isInPhoto(voxels[0], Transform::Identity(), camera()));
    EXPECT_FALSE(isInPhoto(voxels[1], Transform::Identity(), camera()));
    EXPECT_FALSE(isInPhoto(voxels[2], Transform::Identity(), camera()));
    EXPECT_GE(projected.hull_px.size(), 3U);
}

}  // namespace
}  // namespace fodscope
