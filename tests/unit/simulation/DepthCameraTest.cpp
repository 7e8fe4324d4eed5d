// SPDX-License-Identifier: MIT
#include "core/simulation/DepthCamera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "SmallWorlds.h"
#include "core/simulation/PhotoCamera.h"
#include "core/simulation/PoseDrift.h"

namespace fodscope {
namespace {

/// A wall across the optical axis, wide enough to fill the image.
World wallAt(double z_m) {
    World world;
    world.structure = boxMesh({-20.0, -20.0, z_m}, {20.0, 20.0, z_m + 0.1}, {});
    return world;
}

struct Spread {
    double mean = 0.0, deviation = 0.0;
    std::size_t count = 0;
};

Spread spreadOfZ(const World& world, const DepthMappingSettings& settings, std::uint64_t seed) {
    const auto returns = depthFrame(Raycaster(world), Transform::Identity(), settings, seed);
    Spread spread;
    spread.count = returns.size();
    for (const DepthReturn& one : returns)
        spread.mean += static_cast<double>(one.point_camera.z()) / static_cast<double>(returns.size());
    for (const DepthReturn& one : returns)
        spread.deviation += std::pow(static_cast<double>(one.point_camera.z()) - spread.mean, 2);
    spread.deviation = std::sqrt(spread.deviation / static_cast<double>(returns.size() - 1));
    return spread;
}

TEST(DepthCamera, NoiseGrowsWithTheSquareOfTheDistance) {
    DepthMappingSettings settings;
    settings.disparityStep_px = 0.0;
    settings.maximumRange_m = 10.0;
    for (const double z : {0.5, 1.0, 2.0}) {
        const Spread spread = spreadOfZ(wallAt(z), settings, 42);
        ASSERT_EQ(spread.count, 160u * 90u);
        const double expected = 0.002 * z * z;
        // The standard error of a standard deviation over n samples is σ/√(2n): 0.6 %.
        EXPECT_NEAR(spread.deviation, expected, 0.03 * expected) << z;
        EXPECT_NEAR(spread.mean, z, 5.0 * expected / std::sqrt(14400.0)) << z;
    }
}

TEST(DepthCamera, StepsOfDisparityAddTheirOwnSpread) {
    DepthMappingSettings settings;
    settings.maximumRange_m = 10.0;
    const double z = 1.5;
    // At z a step of d px of disparity f·b/z is z²·d/(f·b); evenly spread over it the deviation is its 12th part's
    // root.
    const double step = z * z * 0.125 / (446.8 * 0.05);
    const double noise = 0.002 * z * z;
    const Spread spread = spreadOfZ(wallAt(z), settings, 7);
    EXPECT_NEAR(spread.deviation, std::sqrt(noise * noise + step * step / 12.0), 0.15 * noise);
    EXPECT_NEAR(inDisparitySteps(2.5, settings) / 2.5, 1.0, 0.02);
    const double measured = inDisparitySteps(z, settings);
    EXPECT_NEAR(std::remainder(446.8 * 0.05 / measured, 0.125), 0.0, 1e-9);
}

TEST(DepthCamera, SeesNothingOutOfRange) {
    const DepthMappingSettings settings;
    EXPECT_TRUE(depthFrame(Raycaster(wallAt(0.2)), Transform::Identity(), settings, 1).empty());
    EXPECT_TRUE(depthFrame(Raycaster(wallAt(2.9)), Transform::Identity(), settings, 1).empty());
    EXPECT_FALSE(depthFrame(Raycaster(wallAt(1.0)), Transform::Identity(), settings, 1).empty());
}

TEST(DepthCamera, SurfacesSeenFlatDropOut) {
    // A floor 5 cm under the lens: its far rows are seen at under 3 degrees.
    World world;
    world.structure = boxMesh({-20.0, 0.05, -20.0}, {20.0, 0.1, 20.0}, {});
    DepthMappingSettings settings;
    settings.maximumRange_m = 10.0;
    settings.minimumRange_m = 0.05;
    const auto withDropouts = depthFrame(Raycaster(world), Transform::Identity(), settings, 1);
    settings.grazingAngle_rad = 0.0;
    const auto without = depthFrame(Raycaster(world), Transform::Identity(), settings, 1);
    EXPECT_LT(withDropouts.size(), 0.95 * without.size());
    EXPECT_GT(withDropouts.size(), 0.5 * without.size());
}

TEST(DepthCamera, PixelsFlyBetweenTheTwoSidesOfAnEdge) {
    World world = wallAt(2.0);
    world.objects.push_back(test::boxObject({-0.2, -0.2, 1.0}, {0.2, 0.2, 1.01}));
    DepthMappingSettings settings;
    const auto between = [&] {
        std::size_t count = 0;
        for (const DepthReturn& one : depthFrame(Raycaster(world), Transform::Identity(), settings, 3)) {
            if (one.point_camera.z() < 1.1F || one.point_camera.z() > 1.85F) continue;
            ++count;
            EXPECT_EQ(one.object, -1) << "what flies is of no object";
        }
        return count;
    };
    EXPECT_GT(between(), 20u);
    settings.flyingPixelShare = 0.0;
    EXPECT_EQ(between(), 0u);
}

TEST(DepthCamera, TheSameSeedGivesTheSameImage) {
    const World world = wallAt(1.0);
    const Raycaster raycaster(world);
    const auto frame = [&](std::uint64_t seed) { return depthFrame(raycaster, Transform::Identity(), {}, seed); };
    const auto first = frame(1), again = frame(1), other = frame(2);
    ASSERT_EQ(first.size(), again.size());
    EXPECT_EQ(first[100].point_camera, again[100].point_camera);
    EXPECT_NE(first[100].point_camera, other[100].point_camera);
}

TEST(PoseDrift, WandersWithTheDeviationAskedForAndForgetsItself) {
    DepthMappingSettings settings;
    std::vector<Transform> drive(20000, Transform::Identity());
    for (std::size_t i = 0; i < drive.size(); ++i)
        drive[i].translation().x() = 0.1 * static_cast<double>(i);
    const auto believed = withDrift(drive, settings);
    double variance = 0.0, near = 0.0, far = 0.0, tilt = 0.0;
    const std::size_t lag = 5, farLag = 200;
    const auto error = [&](std::size_t i) { return believed[i].translation().y() - drive[i].translation().y(); };
    for (std::size_t i = 0; i + farLag < drive.size(); ++i) {
        variance += error(i) * error(i);
        near += error(i) * error(i + lag);
        far += error(i) * error(i + farLag);
        const double yaw = std::atan2(believed[i].linear()(1, 0), believed[i].linear()(0, 0));
        tilt += yaw * yaw;
    }
    const auto count = static_cast<double>(drive.size() - farLag);
    EXPECT_NEAR(std::sqrt(variance / count), settings.driftXy_m, 0.2 * settings.driftXy_m);
    EXPECT_NEAR(std::sqrt(tilt / count), settings.driftYaw_rad, 0.2 * settings.driftYaw_rad);
    // Over 0.5 m the process keeps exp(−0.5/2.5) of itself, over 20 m next to nothing.
    EXPECT_NEAR(near / variance, std::exp(-0.5 / settings.driftLength_m), 0.08);
    EXPECT_NEAR(far / variance, 0.0, 0.2);
}

}  // namespace
}  // namespace fodscope
