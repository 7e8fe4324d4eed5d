// SPDX-License-Identifier: MIT
#include "core/simulation/Raycaster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "SmallWorlds.h"
#include "core/simulation/Random.h"

namespace fodscope {
namespace {

/// Distance to the inside of an axis-parallel box, by slabs.
double toWallsFromInside(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, const Eigen::Vector3d& low,
                         const Eigen::Vector3d& high) {
    double nearest = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0.0) continue;
        const double wall = direction[axis] > 0.0 ? high[axis] : low[axis];
        nearest = std::min(nearest, (wall - origin[axis]) / direction[axis]);
    }
    return nearest;
}

TEST(Raycaster, AgreesWithABoxWorkedOutByHand) {
    const World world = test::room();
    const Raycaster raycaster(world);
    Random random(5);
    for (int i = 0; i < 2000; ++i) {
        const Eigen::Vector3d origin(random.uniform(0.1, 2.9), random.uniform(0.1, 1.9), random.uniform(0.1, 0.9));
        const Eigen::Vector3d direction =
            Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
        const auto hit = raycaster.cast(origin, direction, 10.0);
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->distance_m, toWallsFromInside(origin, direction, {0, 0, 0}, {3, 2, 1}), 1e-5);
        EXPECT_EQ(hit->object, -1);
        EXPECT_NEAR(hit->normal_world.norm(), 1.0, 1e-5);
        EXPECT_LT(hit->normal_world.dot(direction), 0.0) << "the normal looks at the viewer";
    }
}

TEST(Raycaster, TellsWhichObjectWasHitAndInWhichColour) {
    World world = test::room();
    world.objects.push_back(test::boxObject({2.0, 0.9, 0.0}, {2.1, 1.1, 0.3}, {10, 200, 30}));
    world.objects.push_back(test::boxObject({1.0, 0.2, 0.0}, {1.1, 0.4, 0.3}, {90, 20, 30}));
    const Raycaster raycaster(world);
    const auto first = raycaster.cast({0.5, 1.0, 0.1}, Eigen::Vector3d::UnitX(), 10.0);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->object, 0);
    EXPECT_NEAR(first->distance_m, 1.5, 1e-6);
    EXPECT_EQ(first->colour, (Rgb{10, 200, 30}));
    const auto second = raycaster.cast({0.5, 0.3, 0.1}, Eigen::Vector3d::UnitX(), 10.0);
    ASSERT_TRUE(second);
    EXPECT_EQ(second->object, 1);
}

TEST(Raycaster, RangeEndsTheRay) {
    const World world = test::room();
    const Raycaster raycaster(world);
    EXPECT_FALSE(raycaster.cast({1.0, 1.0, 0.5}, Eigen::Vector3d::UnitX(), 1.9));
    EXPECT_TRUE(raycaster.cast({1.0, 1.0, 0.5}, Eigen::Vector3d::UnitX(), 2.1));
}

TEST(Raycaster, TheDirectionNeedNotBeOfUnitLength) {
    const World world = test::room();
    const Raycaster raycaster(world);
    const auto hit = raycaster.cast({1.0, 1.0, 0.5}, Eigen::Vector3d(0.01, 0.0, 0.0), 10.0);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance_m, 2.0, 1e-5);
}

TEST(Raycaster, MeaninglessRaysHitNothing) {
    const World world = test::room();
    const Raycaster raycaster(world);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(raycaster.cast({1.0, 1.0, 0.5}, Eigen::Vector3d::Zero(), 10.0));
    EXPECT_FALSE(raycaster.cast({1.0, 1.0, 0.5}, {nan, 0.0, 0.0}, 10.0));
    EXPECT_FALSE(raycaster.cast({nan, 1.0, 0.5}, Eigen::Vector3d::UnitX(), 10.0));
}

TEST(Raycaster, AnEmptyWorldIsEmpty) {
    const World world;
    const Raycaster raycaster(world);
    EXPECT_FALSE(raycaster.cast({0, 0, 0}, Eigen::Vector3d::UnitX(), 100.0));
    EXPECT_FALSE(raycaster.blocked({0, 0, 0}, {1, 0, 0}));
}

TEST(Raycaster, AbsurdVerticesDoNoHarm) {
    World world = test::room();
    append(world.structure, quadMesh({1e300, 0, 0}, {0, 1e30, 0}, {0, 0, 1e20}, {-1e300, 1e18, 0}, {}));
    const auto hit = Raycaster(world).cast({1.0, 1.0, 0.5}, Eigen::Vector3d::UnitX(), 10.0);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance_m, 2.0, 1e-5);
}

TEST(Raycaster, BlockedLooksBetweenTwoPointsOnly) {
    World world = test::room();
    world.objects.push_back(test::boxObject({1.4, 0.0, 0.0}, {1.6, 2.0, 0.5}));
    const Raycaster raycaster(world);
    EXPECT_TRUE(raycaster.blocked({1.0, 1.0, 0.2}, {2.0, 1.0, 0.2}));
    EXPECT_FALSE(raycaster.blocked({1.0, 1.0, 0.2}, {1.3, 1.0, 0.2}));
    EXPECT_FALSE(raycaster.blocked({1.0, 1.0, 0.8}, {2.0, 1.0, 0.8}));
}

TEST(Raycaster, RoundSurfacesShadeSmoothlyAndEdgesStaySharp) {
    World world;
    world.structure = cylinderMesh({0, 0, -1}, {0, 0, 1}, 0.5, {}, 24);
    const Raycaster round(world);
    const double angle = 0.1;
    const Eigen::Vector3d outwards(std::cos(angle), std::sin(angle), 0.0);
    const auto hit = round.cast(3.0 * outwards, -outwards, 10.0);
    ASSERT_TRUE(hit);
    EXPECT_GT(hit->normal_world.dot(outwards), std::cos(0.01)) << "a facet alone would be up to 7.5 degrees off";

    const World box = test::room();
    const auto wall = Raycaster(box).cast({1.5, 1.99, 0.5}, Eigen::Vector3d::UnitX(), 10.0);
    ASSERT_TRUE(wall);
    EXPECT_NEAR(wall->normal_world.x(), -1.0, 1e-5);
}

}  // namespace
}  // namespace fodscope
