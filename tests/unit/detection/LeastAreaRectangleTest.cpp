// SPDX-License-Identifier: MIT
#include "core/detection/LeastAreaRectangle.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace fodscope {
namespace {

constexpr double kPi = std::numbers::pi;

/// A filled 3 × 1 rectangle, turned.
std::vector<Eigen::Vector2d> turnedRectangle(double angle_rad) {
    std::vector<Eigen::Vector2d> points;
    for (int x = 0; x <= 6; ++x)
        for (int y = 0; y <= 2; ++y)
            points.push_back(Eigen::Rotation2Dd(angle_rad) * Eigen::Vector2d(0.5 * x + 4.0, 0.5 * y - 2.0));
    return points;
}

TEST(LeastAreaRectangle, FindsATurnedRectangle) {
    for (const double angle : {-1.5, -0.7, 0.0, 0.3, 1.2, 1.57}) {
        const OrientedRectangle found = leastAreaRectangle(turnedRectangle(angle));
        EXPECT_NEAR(found.length_m, 3.0, 1e-9);
        EXPECT_NEAR(found.width_m, 1.0, 1e-9);
        EXPECT_NEAR(std::remainder(found.direction_rad - angle, kPi), 0.0, 1e-9);
        EXPECT_GT(found.direction_rad, -kPi / 2.0);
        EXPECT_LE(found.direction_rad, kPi / 2.0);
    }
}

TEST(LeastAreaRectangle, MeasuresLinesAndSinglePoints) {
    const OrientedRectangle line = leastAreaRectangle({{0.0, 0.0}, {1.0, 1.0}, {2.0, 2.0}, {1.0, 1.0}});
    EXPECT_NEAR(line.length_m, std::sqrt(8.0), 1e-12);
    EXPECT_NEAR(line.width_m, 0.0, 1e-12);
    EXPECT_NEAR(line.direction_rad, kPi / 4.0, 1e-12);
    EXPECT_NEAR(leastAreaRectangle({{0.0, 1.0}, {0.0, 0.0}}).direction_rad, kPi / 2.0, 1e-12);
    for (const auto& points : {std::vector<Eigen::Vector2d>{{3.0, 4.0}}, std::vector<Eigen::Vector2d>{}}) {
        EXPECT_EQ(leastAreaRectangle(points).length_m, 0.0);
        EXPECT_EQ(leastAreaRectangle(points).width_m, 0.0);
    }
}

}  // namespace
}  // namespace fodscope
