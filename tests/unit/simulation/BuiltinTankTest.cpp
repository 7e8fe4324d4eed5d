// SPDX-License-Identifier: MIT
#include "core/simulation/BuiltinTank.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/common/Error.h"
#include "core/simulation/MeshShapes.h"
#include "core/simulation/Random.h"
#include "core/simulation/Raycaster.h"

namespace fodscope {
namespace {

TEST(BuiltinTank, HasTheSizeAskedFor) {
    const Eigen::AlignedBox3d bounds = boundsOf(builtinTankCad({}));
    EXPECT_NEAR(bounds.min().norm(), 0.0, 0.01);
    EXPECT_NEAR(bounds.max().x(), 3.0, 0.01);
    EXPECT_NEAR(bounds.max().y(), 2.8, 0.01);
    EXPECT_NEAR(bounds.max().z(), 1.0, 0.07) << "the coaming of the access hole stands over the deck";

    BuiltinTankSettings large;
    large.length_m = 5.0;
    large.width_m = 4.0;
    large.height_m = 1.6;
    const Eigen::AlignedBox3d wide = boundsOf(builtinTankCad(large));
    EXPECT_NEAR(wide.max().x(), 5.0, 0.01);
    EXPECT_NEAR(wide.max().y(), 4.0, 0.01);
    EXPECT_NEAR(wide.max().z(), 1.6, 0.07);
}

TEST(BuiltinTank, IsClosedButForTheAccessHole) {
    World world;
    world.structure = builtinTankCad({});
    const Raycaster raycaster(world);
    Random random(3);
    const Eigen::Vector3d origin(1.1, 1.1, 0.5);
    int outside = 0;
    for (int i = 0; i < 20000; ++i) {
        const Eigen::Vector3d direction =
            Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
        if (raycaster.cast(origin, direction, 20.0)) continue;
        ++outside;
        ASSERT_GT(direction.z(), 0.0);
        const Eigen::Vector3d atDeck = origin + direction * (1.0 - origin.z()) / direction.z();
        const double x = (atDeck.x() - 0.66) / 0.30, y = (atDeck.y() - 0.644) / 0.20;
        EXPECT_LT(x * x + y * y, 1.01) << "light comes through at " << atDeck.transpose();
    }
    EXPECT_GT(outside, 100) << "the access hole is open";
}

TEST(BuiltinTank, TheSideShellIsCurved) {
    World world;
    world.structure = builtinTankCad({});
    const Raycaster raycaster(world);
    const auto shellAt = [&](double x, double z) {
        const auto hit = raycaster.cast({x, 2.2, z}, Eigen::Vector3d::UnitY(), 5.0);
        return hit ? 2.2 + hit->distance_m : 0.0;
    };
    EXPECT_GT(shellAt(1.2, 0.4) - shellAt(1.2, 0.03), 0.15) << "a bilge rounds the shell into the floor";
    EXPECT_GT(shellAt(1.2, 0.4) - shellAt(2.9, 0.4), 0.03) << "the shell draws in along the tank";
}

TEST(BuiltinTank, WithoutDeviationItIsBuiltAsDrawn) {
    BuiltinTankSettings exact;
    exact.asBuiltDeviation_m = 0.0;
    EXPECT_EQ(builtinWorld(exact).structure.vertices, builtinTankCad(exact).vertices);
    EXPECT_TRUE(builtinTankCad(exact).colours.empty());
    EXPECT_EQ(builtinWorld(exact).structure.colours.size(), builtinWorld(exact).structure.vertices.size());
}

TEST(BuiltinTank, AsBuiltDiffersFromTheDrawing) {
    const World world = builtinWorld({});
    World drawn;
    drawn.structure = builtinTankCad({});
    const Raycaster built(world), cad(drawn);
    // The column moved, by at most the deviation.
    const auto columnFront = [](const Raycaster& raycaster) {
        return raycaster.cast({1.56, 1.0, 0.6}, Eigen::Vector3d::UnitY(), 2.0)->distance_m;
    };
    EXPECT_NE(columnFront(built), columnFront(cad));
    EXPECT_NEAR(columnFront(built), columnFront(cad), 0.021);
    // The junction box is in no drawing.
    const auto toBox = [](const Raycaster& raycaster) {
        return raycaster.cast({2.5, 0.58 * 2.8, 0.34}, Eigen::Vector3d::UnitX(), 2.0)->distance_m;
    };
    EXPECT_LT(toBox(built), toBox(cad) - 0.05);
}

TEST(BuiltinTank, TheSeedMakesAnotherYard) {
    BuiltinTankSettings other;
    other.seed = 2;
    EXPECT_NE(builtinWorld({}).structure.vertices, builtinWorld(other).structure.vertices);
    EXPECT_EQ(builtinWorld({}).structure.vertices, builtinWorld({}).structure.vertices);
}

TEST(BuiltinTank, ImpossibleSizesAreRefused) {
    BuiltinTankSettings settings;
    settings.length_m = 0.0;
    EXPECT_THROW(builtinWorld(settings), Error);
    settings = {};
    settings.height_m = std::nan("");
    EXPECT_THROW(builtinTankCad(settings), Error);
    settings = {};
    settings.asBuiltDeviation_m = 1.0;
    EXPECT_THROW(builtinWorld(settings), Error);
}

}  // namespace
}  // namespace fodscope
