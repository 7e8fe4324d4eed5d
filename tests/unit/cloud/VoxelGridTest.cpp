// SPDX-License-Identifier: MIT
#include "core/cloud/VoxelGrid.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "core/common/Error.h"
#include "tests/unit/cloud/RandomPoints.h"

namespace fodscope {
namespace {

TEST(VoxelGrid, GivesMeansAndCountsInLexicographicOrder) {
    const auto points = randomPoints(2000, 21);
    const Eigen::Vector3d origin(0.3, -0.1, 0.0);
    std::map<std::array<double, 3>, std::pair<Eigen::Vector3d, std::uint32_t>> expected;
    for (const Eigen::Vector3d& point : points) {
        const Eigen::Vector3d cell = ((point - origin) / 0.2).array().floor();
        auto& [sum, count] =
            expected.try_emplace({cell.x(), cell.y(), cell.z()}, Eigen::Vector3d::Zero(), 0u).first->second;
        sum += point;
        ++count;
    }
    const VoxelCloud voxels = voxelGrid(points, origin, {0.2});
    ASSERT_EQ(voxels.size(), expected.size());
    std::size_t i = 0;
    for (const auto& [cell, voxel] : expected) {
        EXPECT_EQ(voxels.weights[i], voxel.second);
        EXPECT_NEAR((voxels.points[i] - voxel.first / voxel.second).norm(), 0.0, 1e-12);
        ++i;
    }
    EXPECT_EQ(std::accumulate(voxels.weights.begin(), voxels.weights.end(), 0u), 2000u);
}

TEST(VoxelGrid, PutsAPointOnTheBorderIntoTheUpperVoxel) {
    const std::vector<Eigen::Vector3d> points{{0.0, 0.0, 0.0}, {0.5, 0.0, 0.0}, {-0.5, 0.0, 0.0}};
    const VoxelCloud voxels = voxelGrid(points, Eigen::Vector3d::Zero(), {0.5});
    EXPECT_EQ(voxels.points, (std::vector<Eigen::Vector3d>{{-0.5, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.5, 0.0, 0.0}}));
}

TEST(VoxelGrid, RefusesASizeThatIsNotPositiveAndALatticeThatIsTooLarge) {
    const std::vector<Eigen::Vector3d> points{{0.0, 0.0, 0.0}, {1000.0, 0.0, 0.0}};
    EXPECT_THROW(voxelGrid(points, Eigen::Vector3d::Zero(), {0.0}), Error);
    EXPECT_THROW(voxelGrid(points, Eigen::Vector3d::Zero(), {-1.0}), Error);
    EXPECT_THROW(voxelGrid(points, Eigen::Vector3d::Zero(), {std::nan("")}), Error);
    EXPECT_THROW(voxelGrid(points, Eigen::Vector3d::Zero(), {1e-4}), Error);
    EXPECT_EQ(voxelGrid(points, Eigen::Vector3d::Zero(), {1e-3}).size(), 2u);
    EXPECT_EQ(voxelGrid({}, Eigen::Vector3d::Zero(), {1e-3}).size(), 0u);
}

TEST(VoxelGrid, RefusesPointsThatAreNotFinite) {
    const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
        const std::vector<Eigen::Vector3d> points{{0.0, 0.0, 0.0}, {0.0, bad, 0.0}, {1.0, 1.0, 1.0}};
        EXPECT_THROW(voxelGrid(points, origin, {0.1}), Error);
        EXPECT_THROW(voxelGrid(std::vector<Eigen::Vector3d>{points[0]}, points[1], {0.1}), Error);
    }
}

TEST(Corners, BoundThePointsAndNeedAtLeastOne) {
    const std::vector<Eigen::Vector3d> points{{1.0, -2.0, 3.0}, {-4.0, 5.0, 0.0}};
    EXPECT_EQ(minimumCorner(points), Eigen::Vector3d(-4.0, -2.0, 0.0));
    EXPECT_EQ(maximumCorner(points), Eigen::Vector3d(1.0, 5.0, 3.0));
    EXPECT_THROW(minimumCorner({}), Error);
    EXPECT_THROW(maximumCorner({}), Error);
}

}  // namespace
}  // namespace fodscope
