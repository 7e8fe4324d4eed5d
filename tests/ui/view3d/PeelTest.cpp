// SPDX-License-Identifier: MIT
#include "ui/view3d/Peel.h"

#include <gtest/gtest.h>

#include <vector>

namespace fodscope {
namespace {

/// A box 4 × 3 × 2 m with points 5 cm apart, its floor at z = 1.
std::vector<Eigen::Vector3d> tank(bool withDeck) {
    std::vector<Eigen::Vector3d> points;
    for (int x = 0; x <= 80; ++x) {
        for (int y = 0; y <= 60; ++y) {
            points.emplace_back(0.05 * x, 0.05 * y, 1.0);
            if (withDeck) points.emplace_back(0.05 * x, 0.05 * y, 3.0);
        }
        for (int z = 0; z <= 40; ++z) {
            points.emplace_back(0.05 * x, 0.0, 1.0 + 0.05 * z);
            points.emplace_back(0.05 * x, 3.0, 1.0 + 0.05 * z);
        }
    }
    return points;
}

TEST(Peel, OpensATankBelowItsDeck) {
    const auto height = openingHeight(tank(true));
    ASSERT_TRUE(height.has_value());
    EXPECT_GT(*height, 2.0);
    EXPECT_LT(*height, 2.95);
}

TEST(Peel, LeavesWhatIsOpenFromAbove) {
    EXPECT_FALSE(openingHeight(tank(false)).has_value());
}

TEST(Peel, LeavesFlatAndTinyClouds) {
    EXPECT_FALSE(openingHeight({}).has_value());
    EXPECT_FALSE(openingHeight(std::vector<Eigen::Vector3d>(500, Eigen::Vector3d(1, 2, 3))).has_value());
}

}  // namespace
}  // namespace fodscope
