// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/common/Error.h"
#include "core/detection/Candidates.h"

namespace fodscope {
namespace {

void addLayer(ReferenceMap& reference, double z, int edge) {
    for (int x = 0; x < edge; ++x)
        for (int y = 0; y < edge; ++y)
            reference.points.emplace_back(0.05 * x, 0.05 * y, z + (x % 2 == 0 ? 0.002 : -0.002));
}

TEST(FloorHeight, IsTheLowestOfTheLargeLayers) {
    ReferenceMap reference;
    addLayer(reference, 0.25, 40);  // floor
    addLayer(reference, 1.10, 50);  // ceiling, larger
    for (int i = 0; i < 40; ++i)
        for (int j = 0; j < 20; ++j)
            reference.points.emplace_back(0.05 * i, 0.0, 0.25 + 0.04 * j);  // wall
    for (int i = 0; i < 20; ++i)
        reference.points.emplace_back(0.1 * i, 0.3, -0.1 - 0.004 * i);  // noise under the floor
    EXPECT_NEAR(floorHeight(reference), 0.25, 0.003);
}

TEST(FloorHeight, DoesNotDependOnWhereTheHistogramBegins) {
    for (int i = 0; i < 10; ++i) {
        ReferenceMap reference;
        addLayer(reference, 0.0, 40);
        reference.points.emplace_back(0.0, 0.0, -0.05 - 0.001 * i);
        EXPECT_NEAR(floorHeight(reference), 0.0, 1e-6);
    }
}

TEST(FloorHeight, OfASinglePointIsItsHeight) {
    ReferenceMap reference;
    EXPECT_THROW(floorHeight(reference), Error);
    reference.points.emplace_back(1.0, 2.0, 3.0);
    EXPECT_DOUBLE_EQ(floorHeight(reference), 3.0);
}

}  // namespace
}  // namespace fodscope
