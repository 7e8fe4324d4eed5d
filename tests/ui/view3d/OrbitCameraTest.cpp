// SPDX-License-Identifier: MIT
#include "ui/view3d/OrbitCamera.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>

#include "ui/view3d/Picking.h"

namespace fodscope {
namespace {

constexpr double kQuarterTurn_rad = 1.57079632679489661923;

Bounds box(double x, double y, double z) {
    Bounds bounds;
    bounds.extend(Eigen::Vector3d(-x, -y, -z));
    bounds.extend(Eigen::Vector3d(x, y, z));
    return bounds;
}

TEST(OrbitCamera, KeepsARightHandedFrameAtEveryTurn) {
    OrbitCamera camera;
    for (const double elevation : {-kQuarterTurn_rad, -0.4, 0.0, 0.9, kQuarterTurn_rad}) {
        camera.elevation_rad = elevation;
        EXPECT_NEAR(camera.right().cross(camera.forward()).dot(camera.up()), 1.0, 1e-12);
        EXPECT_GE(camera.up().z(), -1e-12) << "z must stay up";
    }
}

TEST(OrbitCamera, SeesNorthUpFromAbove) {
    OrbitCamera camera;
    camera.azimuth_rad = -kQuarterTurn_rad;
    camera.elevation_rad = kQuarterTurn_rad;
    EXPECT_TRUE(camera.up().isApprox(Eigen::Vector3d::UnitY(), 1e-9));
    EXPECT_TRUE(camera.right().isApprox(Eigen::Vector3d::UnitX(), 1e-9));
}

TEST(OrbitCamera, NeverTurnsOverThePole) {
    const OrbitCamera camera = orbited(OrbitCamera(), 0.0, 5000.0, 600.0);
    EXPECT_NEAR(camera.elevation_rad, kQuarterTurn_rad, 1e-12);
}

TEST(OrbitCamera, PanMovesThePointUnderThePointerWithIt) {
    const OrbitCamera before;
    const auto from = ScreenProjection(before, 800, 600).project(before.focus);
    const auto to = ScreenProjection(panned(before, 40.0, -25.0, 600), 800, 600).project(before.focus);
    EXPECT_NEAR(to->x_px - from->x_px, 40.0, 1e-6);
    EXPECT_NEAR(to->y_px - from->y_px, -25.0, 1e-6);
}

TEST(OrbitCamera, ZoomKeepsTheAnchorInPlace) {
    const OrbitCamera before;
    const Eigen::Vector3d anchor(1.2, -0.7, 0.4);
    const auto from = ScreenProjection(before, 800, 600).project(anchor);
    const auto to = ScreenProjection(zoomed(before, 0.5, anchor), 800, 600).project(anchor);
    EXPECT_NEAR(to->x_px, from->x_px, 1e-6);
    EXPECT_NEAR(to->y_px, from->y_px, 1e-6);
}

TEST(OrbitCamera, FitShowsEveryCornerAndTouchesTheMargin) {
    for (const bool parallel : {false, true}) {
        OrbitCamera camera;
        camera.parallel = parallel;
        const Bounds bounds = box(6.0, 1.0, 0.5);
        const ScreenProjection screen(fitted(camera, bounds, 1.6, 0.1), 1600, 1000);
        double farthest = 0.0;
        for (int corner = 0; corner < 8; ++corner) {
            const auto spot = screen.project(
                Eigen::Vector3d(corner & 1 ? 6.0 : -6.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 0.5 : -0.5));
            farthest = std::max(farthest, std::abs(spot->x_px / 800.0 - 1.0));
            farthest = std::max(farthest, std::abs(spot->y_px / 500.0 - 1.0));
        }
        EXPECT_NEAR(farthest, 0.9, 1e-6);
    }
}

TEST(OrbitCamera, FlightTakesTheShorterWayRound) {
    OrbitCamera from;
    OrbitCamera to;
    from.azimuth_rad = 3.0;
    to.azimuth_rad = -3.0;
    const double halfway = between(from, to, 0.5).azimuth_rad;
    EXPECT_NEAR(std::abs(halfway), 3.14159265358979, 1e-9);
    EXPECT_NEAR(between(from, to, 1.0).azimuth_rad, -3.0, 1e-12);
}

}  // namespace
}  // namespace fodscope
