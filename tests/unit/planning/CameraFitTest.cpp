// SPDX-License-Identifier: MIT
#include "core/planning/CameraFit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/common/Error.h"

namespace fodscope {
namespace {

constexpr double kHalfTurn_rad = 3.14159265358979;

PhotoPart boxPart(const Eigen::Vector3d& centre, const Eigen::Vector3d& size) {
    return wholeOf({"C-001", centre, size, 0.0, {}, 0.02}, 0);
}

/// The picture's own test, corner by corner, with the pinhole that photos are projected by.
bool isWholeInPicture(const Pose2& robot, const PhotoPart& part, const CameraSettings& camera,
                      const WaypointSettings& settings) {
    const CameraIntrinsics k = intrinsicsOf(camera);
    const Transform T_camera_from_map = cameraPose(robot, camera).inverse();
    for (const Eigen::Vector2d& corner : part.footprint_map) {
        for (const double z : {part.low_m, part.high_m}) {
            const Eigen::Vector3d seen = T_camera_from_map * Eigen::Vector3d(corner.x(), corner.y(), z);
            if (seen.z() < camera.nearLimit_m || seen.norm() > settings.coarsestPixel_m * k.fx_px) return false;
            const Eigen::Vector2d pixel = pixelOf(seen, k);
            const double besides = settings.edgeMargin * k.width_px, above = settings.edgeMargin * k.height_px;
            if (pixel.x() < besides || pixel.x() > k.width_px - besides) return false;
            if (pixel.y() < above || pixel.y() > k.height_px - above) return false;
        }
    }
    return true;
}

TEST(CameraFit, theYawsAreThoseForWhichEveryCornerProjectsIntoThePhoto) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    int fits = 0, yawsInside = 0;
    for (int trial = 0; trial < 1500; ++trial) {
        CameraSettings camera;
        camera.pitchDown_rad = radiansFromDegrees(-10.0 + 30.0 * share(random));
        camera.height_m = 0.05 + 0.5 * share(random);
        WaypointSettings settings;
        const Eigen::Vector3d size(0.02 + 0.5 * share(random), 0.02 + 0.3 * share(random), 0.02 + 0.3 * share(random));
        const PhotoPart part = boxPart({1.0, -2.0, 0.5 * size.z() + 0.3 * share(random) * share(random)}, size);
        const double angle = 6.28 * share(random), distance = 0.2 + 1.4 * share(random);
        const Eigen::Vector2d place(1.0 + distance * std::cos(angle), -2.0 + distance * std::sin(angle));
        YawRange yaws;
        const PictureFit fit = CameraFit(camera, settings).fit(place, part, yaws);
        const double facing = std::atan2(-2.0 - place.y(), 1.0 - place.x());
        for (int step = -60; step <= 60; ++step) {
            const double yaw = facing + step * kHalfTurn_rad / 180.0;
            const bool isWhole = isWholeInPicture({place.x(), place.y(), yaw}, part, camera, settings);
            if (fit != PictureFit::Fits) {
                // Nothing is lost but where the whole is beside the bearing of its centre.
                if (step == 0) {
                    EXPECT_FALSE(isWhole);
                }
                continue;
            }
            const bool isInside = yaw >= yaws.lowest_rad && yaw <= yaws.highest_rad;
            const double edge = std::min(std::abs(yaw - yaws.lowest_rad), std::abs(yaw - yaws.highest_rad));
            if (edge > 1e-9) {
                ASSERT_EQ(isWhole, isInside) << "trial " << trial << ", yaw " << yaw;
            }
            yawsInside += isInside ? 1 : 0;
        }
        fits += fit == PictureFit::Fits ? 1 : 0;
    }
    EXPECT_GT(fits, 150);
    EXPECT_GT(yawsInside, 4000);
}

TEST(CameraFit, tellsWhatKeepsAThingOutOfThePicture) {
    const CameraFit camera(CameraSettings{}, WaypointSettings{});
    YawRange yaws;
    EXPECT_EQ(camera.fit({0.7, 0.0}, boxPart({0, 0, 0.05}, {0.1, 0.1, 0.1}), yaws), PictureFit::Fits);
    // 16° over the horizon the picture ends: at 0.7 m that is 0.4 m up.
    EXPECT_EQ(camera.fit({0.7, 0.0}, boxPart({0, 0, 0.6}, {0.1, 0.1, 0.1}), yaws), PictureFit::TooHigh);
    // 26° under it: floor nearer than 0.41 m is under the picture.
    EXPECT_EQ(camera.fit({0.35, 0.0}, boxPart({0, 0, 0.05}, {0.1, 0.1, 0.1}), yaws), PictureFit::TooNear);
    // 0.9 m of it do not fit side by side at 0.5 m.
    EXPECT_EQ(camera.fit({0.5, 0.0}, boxPart({0, 0, 0.2}, {0.02, 0.9, 0.02}), yaws), PictureFit::TooNear);
    EXPECT_EQ(camera.fit({2.5, 0.0}, boxPart({0, 0, 0.05}, {0.1, 0.1, 0.1}), yaws), PictureFit::TooFar);
}

TEST(CameraFit, refusesCamerasThatCannotBe) {
    const auto make = [](auto change) {
        CameraSettings camera;
        change(camera);
        return CameraFit(camera, {});
    };
    EXPECT_THROW(make([](CameraSettings& c) { c.width_px = 0; }), Error);
    EXPECT_THROW(make([](CameraSettings& c) { c.horizontalFieldOfView_rad = 3.2; }), Error);
    EXPECT_THROW(make([](CameraSettings& c) { c.height_m = -0.1; }), Error);
    EXPECT_THROW(make([](CameraSettings& c) { c.pitchDown_rad = std::nan(""); }), Error);
}

}  // namespace
}  // namespace fodscope
