// SPDX-License-Identifier: MIT
#include "core/simulation/PhotoCamera.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "SmallWorlds.h"
#include "core/common/Error.h"

namespace fodscope {
namespace {

PhotoCameraSettings smallCamera() {
    PhotoCameraSettings settings;
    settings.width_px = 320;
    settings.height_px = 180;
    return settings;
}

cv::Mat decoded(const std::vector<std::byte>& bytes) {
    const cv::Mat raw(1, static_cast<int>(bytes.size()), CV_8UC1, const_cast<std::byte*>(bytes.data()));
    return cv::imdecode(raw, cv::IMREAD_COLOR);
}

TEST(PhotoCamera, SeesSixtyNineDegreesAcross) {
    const CameraIntrinsics intrinsics = intrinsicsOf({});
    EXPECT_EQ(intrinsics.width_px, 1280);
    EXPECT_EQ(intrinsics.height_px, 720);
    EXPECT_NEAR(2.0 * degreesFromRadians(std::atan(640.0 / intrinsics.fx_px)), 69.0, 0.01);
    EXPECT_EQ(intrinsics.fx_px, intrinsics.fy_px);
}

TEST(PhotoCamera, LooksAheadAndDownFromTheRobot) {
    const Transform pose = cameraPose({1.0, 2.0, 1.5707963267948966}, {});
    EXPECT_TRUE(pose.translation().isApprox(Eigen::Vector3d(1.0, 2.0, 0.20)));
    const Eigen::Vector3d forward = pose.linear().col(2), right = pose.linear().col(0), down = pose.linear().col(1);
    EXPECT_NEAR(forward.y(), std::cos(radiansFromDegrees(5.0)), 1e-9);
    EXPECT_NEAR(forward.z(), -std::sin(radiansFromDegrees(5.0)), 1e-9);
    EXPECT_TRUE(right.isApprox(Eigen::Vector3d::UnitX()));
    EXPECT_LT(down.z(), 0.0);
    EXPECT_NEAR(pose.linear().determinant(), 1.0, 1e-12);
}

TEST(PhotoCamera, APhotoIsAJpegOfItsSizeAndShowsTheObject) {
    World world = test::room();
    world.objects.push_back(test::boxObject({1.6, 0.9, 0.0}, {1.7, 1.1, 0.15}, {210, 20, 20}));
    const PhotoCameraSettings settings = smallCamera();
    const std::vector<std::byte> bytes =
        renderPhoto(world, Raycaster(world), cameraPose({1.0, 1.0, 0.0}, settings), settings);
    ASSERT_GT(bytes.size(), 4u);
    EXPECT_EQ(bytes[0], std::byte{0xff});
    EXPECT_EQ(bytes[1], std::byte{0xd8});
    const cv::Mat image = decoded(bytes);
    ASSERT_EQ(image.cols, 320);
    ASSERT_EQ(image.rows, 180);
    // The middle of the box, projected by hand: 0.6 m ahead, 0.125 m under the lens, pitched 5 degrees down.
    const CameraIntrinsics k = intrinsicsOf(settings);
    const double row = k.cy_px + k.fy_px * std::tan(std::atan2(0.125, 0.6) - settings.pitchDown_rad);
    const cv::Vec3b pixel = image.at<cv::Vec3b>(static_cast<int>(row), 160);
    EXPECT_GT(pixel[2], 2 * pixel[1]) << "the object keeps its red";
    EXPECT_GT(pixel[2], 2 * pixel[0]);
}

TEST(PhotoCamera, ExposesWellAtTheDistancesPhotosAreTakenFrom) {
    for (const double distance : {0.5, 0.75}) {
        World world = test::room();
        world.objects.push_back(
            test::boxObject({1.0 + distance, 0.9, 0.0}, {1.1 + distance, 1.1, 0.15}, {150, 150, 150}));
        const PhotoCameraSettings settings = smallCamera();
        const cv::Mat image =
            decoded(renderPhoto(world, Raycaster(world), cameraPose({1.0, 1.0, 0.0}, settings), settings));
        const cv::Rect middle(80, 60, 160, 100);
        cv::Mat grey;
        cv::transform(image(middle), grey, cv::Matx13f(0.114f, 0.587f, 0.299f));
        EXPECT_GT(cv::mean(grey)[0], 70.0) << distance;
        EXPECT_LT(cv::mean(grey)[0], 200.0) << distance;
        EXPECT_LT(cv::countNonZero(grey > 250), 0.02 * middle.area()) << "burnt out at " << distance;
    }
}

TEST(PhotoCamera, TheSameSeedGivesTheSameBytesWithAnyNumberOfThreads) {
    World world = test::room();
    world.objects.push_back(test::boxObject({1.6, 0.9, 0.0}, {1.7, 1.1, 0.15}));
    const Raycaster raycaster(world);
    PhotoCameraSettings settings = smallCamera();
    const Transform pose = cameraPose({1.0, 1.0, 0.2}, settings);
    std::vector<std::vector<std::byte>> photos;
    for (const std::size_t threads : {1, 2}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        photos.push_back(renderPhoto(world, raycaster, pose, settings));
    }
    EXPECT_EQ(photos[0], photos[1]);
    settings.seed = 2;
    EXPECT_NE(photos[0], renderPhoto(world, raycaster, pose, settings));
}

TEST(PhotoCamera, ImpossibleImagesAreRefused) {
    const World world = test::room();
    PhotoCameraSettings settings;
    settings.width_px = 0;
    EXPECT_THROW(renderPhoto(world, Raycaster(world), Transform::Identity(), settings), Error);
    settings = {};
    settings.horizontalFieldOfView_rad = 4.0;
    EXPECT_THROW(renderPhoto(world, Raycaster(world), Transform::Identity(), settings), Error);
}

/// Pixels whose centre ray passes a rectangle that stands across the optical axis.
std::size_t pixelsOnRectangle(const CameraIntrinsics& k, double z, double left, double right, double top,
                              double bottom) {
    std::size_t count = 0;
    for (int row = 0; row < k.height_px; ++row) {
        for (int column = 0; column < k.width_px; ++column) {
            const double x = (column + 0.5 - k.cx_px) / k.fx_px * z, y = (row + 0.5 - k.cy_px) / k.fy_px * z;
            if (x > left && x < right && y > top && y < bottom) ++count;
        }
    }
    return count;
}

TEST(PhotoCamera, CanBeCancelled) {
    const World world = test::room();
    Progress progress;
    progress.cancel();
    EXPECT_THROW(renderPhoto(world, Raycaster(world), cameraPose({1.0, 1.0, 0.0}, {}), {}, progress), Cancelled);
}

TEST(VisiblePixels, AgreeWithABoxProjectedByHand) {
    World world;
    // A thin plate 0.8 m ahead of a camera that looks along world x: right is −y, down is −z.
    world.objects.push_back(test::boxObject({0.8, -0.1, -0.05}, {0.8 + 1e-4, 0.15, 0.1}));
    PhotoCameraSettings settings = smallCamera();
    settings.pitchDown_rad = 0.0;
    settings.height_m = 0.0;
    const CameraIntrinsics k = intrinsicsOf(settings);
    const auto pixels = visiblePixels(world, Raycaster(world), cameraPose({}, settings), k);
    const std::size_t expected = pixelsOnRectangle(k, 0.8, -0.15, 0.1, -0.1, 0.05);
    ASSERT_GT(expected, 1000u);
    EXPECT_NEAR(static_cast<double>(pixels.at(0)), static_cast<double>(expected), 3.0);
}

TEST(VisiblePixels, WhatIsHiddenOrBehindDoesNotCount) {
    World world = test::room();
    world.objects.push_back(test::boxObject({2.0, 0.9, 0.0}, {2.1, 1.1, 0.2}));
    world.objects.push_back(test::boxObject({1.8, 0.5, 0.0}, {1.9, 1.5, 0.9}));
    world.objects.push_back(test::boxObject({0.2, 0.9, 0.0}, {0.3, 1.1, 0.2}));
    const auto pixels = visiblePixels(world, Raycaster(world), cameraPose({1.0, 1.0, 0.0}, {}), intrinsicsOf({}));
    ASSERT_EQ(pixels.size(), 3u);
    EXPECT_EQ(pixels[0], 0u) << "hidden by the second";
    EXPECT_GT(pixels[1], 10000u);
    EXPECT_EQ(pixels[2], 0u) << "behind the camera";
}

TEST(VisiblePixels, AnObjectThroughTheImagePlaneCounts) {
    World world = test::room();
    world.objects.push_back(test::boxObject({0.5, 0.9, 0.0}, {2.0, 1.1, 0.1}));
    const auto pixels = visiblePixels(world, Raycaster(world), cameraPose({1.0, 1.0, 0.0}, {}), intrinsicsOf({}));
    EXPECT_GT(pixels.at(0), 10000u);
}

}  // namespace
}  // namespace fodscope
