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

/// In plain steps, with the points of a voxel added up in their own order.
VoxelCloud plainVoxelGrid(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& origin, double size_m) {
    std::map<std::array<double, 3>, std::pair<Eigen::Vector3d, std::uint32_t>> sums;
    for (const Eigen::Vector3d& point : points) {
        const Eigen::Vector3d cell = ((point - origin) / size_m).array().floor();
        auto& [sum, count] =
            sums.try_emplace({cell.x(), cell.y(), cell.z()}, Eigen::Vector3d::Zero(), 0u).first->second;
        sum += point;
        ++count;
    }
    VoxelCloud voxels;
    for (const auto& [cell, voxel] : sums) {
        voxels.points.push_back(voxel.first / voxel.second);
        voxels.weights.push_back(voxel.second);
    }
    return voxels;
}

void expectEqual(const VoxelCloud& voxels, const VoxelCloud& expected) {
    EXPECT_EQ(voxels.points, expected.points);
    EXPECT_EQ(voxels.weights, expected.weights);
}

TEST(VoxelGrid, GivesTheSameToTheLastBitInDenseAndSparseAndFarLattices) {
    // Enough for several threads, and negative coordinates.
    std::vector<Eigen::Vector3d> points = randomPoints(70'000, 22);
    for (Eigen::Vector3d& point : points)
        point = 2.0 * point - Eigen::Vector3d(1.0, 0.5, 3.0);
    for (const Eigen::Vector3d& origin :
         {Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(0.17, -0.03, 0.4), Eigen::Vector3d(3e8, -3e8, 0.0)}) {
        for (const double size_m : {0.05, 0.3, 7.0})
            expectEqual(voxelGrid(points, origin, {size_m}), plainVoxelGrid(points, origin, size_m));
    }
    points.emplace_back(20'000.0, -20'000.0, 20'000.0);
    expectEqual(voxelGrid(points, Eigen::Vector3d::Zero(), {0.05}),
                plainVoxelGrid(points, Eigen::Vector3d::Zero(), 0.05));
}

TEST(VoxelGrid, OfMovedPointsIsThatOfACopyMovedAndCropped) {
    const std::vector<Eigen::Vector3d> points = randomPoints(40'000, 23);
    MovedPoints moved{points};
    moved.T_target_from_points.translate(Eigen::Vector3d(0.2, -0.1, 3.0));
    moved.T_target_from_points.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d(0.2, 0.3, 0.9).normalized()));
    expectEqual(voxelGrid(moved, {0.05}), [&] {
        std::vector<Eigen::Vector3d> copy;
        for (const Eigen::Vector3d& point : points)
            copy.push_back(moved.T_target_from_points * point);
        return plainVoxelGrid(copy, minimumCorner(copy), 0.05);
    }());
    moved.low = {0.1, 0.1, 3.1};
    moved.high = {0.6, 0.7, 3.8};
    std::vector<Eigen::Vector3d> inside;
    for (const Eigen::Vector3d& point : points) {
        const Eigen::Vector3d there = moved.T_target_from_points * point;
        if ((there.array() > moved.low.array()).all() && (there.array() < moved.high.array()).all())
            inside.push_back(there);
    }
    ASSERT_GT(inside.size(), 1000u);
    expectEqual(voxelGrid(moved, {0.05}), plainVoxelGrid(inside, minimumCorner(inside), 0.05));
    moved.high = moved.low;
    EXPECT_EQ(voxelGrid(moved, {0.05}).size(), 0u);
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
