// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "SmallWorlds.h"
#include "core/common/Error.h"
#include "core/simulation/BuiltinTank.h"
#include "core/simulation/MeshShapes.h"
#include "core/simulation/Raycaster.h"

namespace fodscope {
namespace {

struct Range {
    double low, high;
};

/// Length and thickness (longest and shortest side of the box) of such tools in makers' catalogues, in metres.
const std::map<std::string, std::pair<Range, Range>> kCatalogue{
    {"hammer", {{0.30, 0.35}, {0.025, 0.04}}},      {"drill", {{0.17, 0.25}, {0.06, 0.09}}},
    {"tape measure", {{0.07, 0.19}, {0.03, 0.05}}}, {"screwdriver", {{0.18, 0.25}, {0.025, 0.045}}},
    {"sander", {{0.15, 0.26}, {0.10, 0.16}}},       {"crimper", {{0.19, 0.25}, {0.012, 0.03}}},
    {"wrench", {{0.19, 0.27}, {0.007, 0.016}}},     {"level", {{0.38, 0.62}, {0.018, 0.03}}},
};

TEST(Fod, EveryTypeHasItsTrueSizeAndLiesOnTheFloor) {
    ASSERT_EQ(fodTypes().size(), kCatalogue.size());
    for (const std::string& type : fodTypes()) {
        const auto& [length, thickness] = kCatalogue.at(type);
        for (std::uint64_t seed = 0; seed < 6; ++seed) {
            const TriangleMesh mesh = fodMesh(type, seed);
            const Eigen::AlignedBox3d bounds = boundsOf(mesh);
            EXPECT_NEAR(bounds.min().z(), 0.0, 1e-9) << type;
            EXPECT_GE(bounds.sizes().maxCoeff(), length.low) << type;
            EXPECT_LE(bounds.sizes().maxCoeff(), length.high) << type;
            EXPECT_GE(bounds.sizes().minCoeff(), thickness.low) << type;
            EXPECT_LE(bounds.sizes().minCoeff(), thickness.high) << type;
            EXPECT_NEAR(surfaceCentroid(mesh).head<2>().norm(), 0.0, 1e-9) << type;
            EXPECT_EQ(mesh.colours.size(), mesh.vertices.size()) << type;
            for (const auto& triangle : mesh.triangles)
                for (const std::uint32_t index : triangle)
                    ASSERT_LT(index, mesh.vertices.size()) << type;
        }
    }
}

TEST(Fod, HasMoreThanOneColour) {
    for (const std::string& type : fodTypes()) {
        std::set<std::array<int, 3>> colours;
        for (const Rgb& colour : fodMesh(type, 1).colours)
            colours.insert({colour.red, colour.green, colour.blue});
        EXPECT_GE(colours.size(), 2u) << type;
    }
}

TEST(Fod, AnUnknownTypeIsNamed) {
    try {
        fodMesh("anvil", 1);
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("anvil"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("hammer"), std::string::npos);
    }
}

class Placement : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(Placement, FollowsTheProtocol) {
    World world = builtinWorld({});
    placeFod(world, GetParam());
    EXPECT_GE(world.objects.size(), 2u);
    EXPECT_LE(world.objects.size(), 5u);
    std::set<std::string> types;
    const World empty = builtinWorld({});
    const Raycaster tank(empty);
    for (const WorldObject& object : world.objects) {
        EXPECT_TRUE(object.fod);
        EXPECT_TRUE(types.insert(object.type).second) << object.type << " was drawn twice";
        EXPECT_TRUE(object.centroid_world.isApprox(surfaceCentroid(object.mesh), 1e-9));
        const Eigen::AlignedBox3d bounds = boundsOf(object.mesh);
        EXPECT_GE(bounds.min().z(), -1e-6);
        EXPECT_LE(bounds.min().z(), 0.021) << "on the floor or on a floor strip";
        // Inside the tank: from over the object there is floor below and deck or open hole above, and walls around.
        const Eigen::Vector3d over(object.centroid_world.x(), object.centroid_world.y(), bounds.max().z() + 0.01);
        const auto floor = tank.cast(over, -Eigen::Vector3d::UnitZ(), 2.0);
        ASSERT_TRUE(floor);
        EXPECT_NEAR(over.z() - floor->distance_m, bounds.min().z(), 0.021);
        for (const Eigen::Vector3d& side :
             {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, -1, 0)})
            EXPECT_TRUE(tank.cast(over, side, 5.0));
        // It does not stick in anything: no vertex has structure right above the floor on the way down to it.
        for (std::size_t i = 0; i < object.mesh.vertices.size(); i += 7) {
            const Eigen::Vector3d top = object.mesh.vertices[i] + Eigen::Vector3d(0, 0, 0.001);
            const auto below = tank.cast(top, -Eigen::Vector3d::UnitZ(), 1.0);
            ASSERT_TRUE(below) << object.type;
            EXPECT_LT(top.z() - below->distance_m, 0.021) << object.type;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Placement, ::testing::Values(1, 2, 3, 4, 5, 6));

TEST(Fod, PlacementIsRepeatable) {
    World first = builtinWorld({}), second = first, other = first;
    placeFod(first, 9);
    placeFod(second, 9);
    placeFod(other, 10);
    ASSERT_EQ(first.objects.size(), second.objects.size());
    for (std::size_t i = 0; i < first.objects.size(); ++i)
        EXPECT_EQ(first.objects[i].mesh.vertices, second.objects[i].mesh.vertices);
    EXPECT_NE(first.objects[0].mesh.vertices, other.objects[0].mesh.vertices);
}

TEST(Fod, PlacementCoversAllTypesAndCounts) {
    std::set<std::string> types;
    std::set<std::size_t> counts;
    for (std::uint64_t seed = 0; seed < 25; ++seed) {
        World world = test::room(4.0, 4.0, 1.0);
        placeFod(world, seed);
        counts.insert(world.objects.size());
        for (const WorldObject& object : world.objects)
            types.insert(object.type);
    }
    EXPECT_EQ(types.size(), 8u);
    EXPECT_EQ(counts, (std::set<std::size_t>{2, 3, 4, 5}));
}

TEST(Fod, AWorldWithoutFreeFloorIsRefused) {
    World world = test::room(0.3, 0.3, 0.5);
    EXPECT_THROW(
        {
            for (std::uint64_t seed = 0; seed < 5; ++seed)
                placeFod(world, seed);
        },
        Error);
    World nothing;
    EXPECT_THROW(placeFod(nothing, 1), Error);
}

}  // namespace
}  // namespace fodscope
