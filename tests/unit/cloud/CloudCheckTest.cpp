// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/cloud/Spacing.h"
#include "core/cloud/UnitCheck.h"
#include "tests/unit/cloud/ExpectError.h"
#include "tests/unit/cloud/RandomPoints.h"

namespace fodscope {
namespace {

TEST(Spacing, OfALatticeIsItsStep) {
    std::vector<Eigen::Vector3d> points;
    for (int x = 0; x < 200; ++x)
        for (int y = 0; y < 150; ++y)
            points.emplace_back(0.02 * x, 0.02 * y, 1.0);
    Progress progress;
    EXPECT_NEAR(medianSpacing_m(points, progress), 0.02, 1e-9);
}

TEST(Spacing, NeedsTwoPoints) {
    Progress progress;
    const std::vector<Eigen::Vector3d> pair{{0.0, 0.0, 0.0}, {0.0, 3.0, 4.0}};
    EXPECT_DOUBLE_EQ(medianSpacing_m(pair, progress), 5.0);
    expectError([&] { medianSpacing_m(std::span(pair).first(1), progress); }, "fewer than two points");
}

TEST(UsableCloud, IsInMetresAndHasEnoughPoints) {
    auto points = randomPoints(1000, 61);
    EXPECT_NO_THROW(requireUsableCloud(points, "map.pcd"));
    for (Eigen::Vector3d& point : points)
        point *= 3000.0;
    expectError([&] { requireUsableCloud(points, "map.pcd"); }, "millimetres");
    expectError([&] { requireUsableCloud(points, "map.pcd"); }, "0.001");
    points.resize(1);
    expectError([&] { requireUsableCloud(points, "map.pcd"); }, "map.pcd: holds only 1 point,");
}

TEST(Metres, AreRequiredOfAMesh) {
    TriangleMesh mesh;
    mesh.vertices = {{0.0, 0.0, 0.0}, {6.2, 0.0, 0.0}, {0.0, 5.0, 0.0}};
    EXPECT_NO_THROW(requireMetres(mesh, "tank.stl"));
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex *= 1000.0;
    expectError([&] { requireMetres(mesh, "tank.stl"); }, "tank.stl: is 6200 m long");
}

}  // namespace
}  // namespace fodscope
