// SPDX-License-Identifier: MIT
#include "core/registration/RegionResiduals.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/common/Error.h"
#include "tests/unit/registration/SyntheticRoom.h"

namespace fodscope {
namespace {

using test::boxPanels;
using test::mapOf;
using test::motion;
using test::Panel;
using test::referenceOf;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;

/// A box of 4 × 3 × 1.2 m without a ceiling whose wall at x = 4 stands `moved_m` farther in.
std::vector<Panel> boxWithMovedWall(double moved_m) {
    std::vector<Panel> panels = boxPanels({0, 0, 0}, {4.0, 3.0, 1.2});
    panels[5].corner.x() -= moved_m;
    panels.erase(panels.begin() + 1);
    return panels;
}

RegionResiduals residualsOf(const std::vector<Panel>& panels, const Transform& T_map_from_room) {
    Progress progress;
    return measureRegionResiduals(mapOf(panels, T_map_from_room), T_map_from_room.inverse(),
                                  referenceOf(boxWithMovedWall(0.0)), {}, progress);
}

TEST(RegionResiduals, AMovedWallIsOffByWhatItWasMoved) {
    const RegionResiduals residuals = residualsOf(boxWithMovedWall(0.020), motion(50.0, {1.0, 2.0, 0.0}));
    std::size_t onTheWall = 0;
    for (const RegionResidual& region : residuals.regions) {
        if (!region.isMeasured()) continue;
        const bool moved = region.kind == SurfaceKind::Wall && region.normal.x() < -0.9;
        EXPECT_NEAR(region.offset_m, moved ? 0.020 : 0.0, 0.003) << regionInWords(region);
        EXPECT_LT(region.spread_m, 0.005);
        if (moved) ++onTheWall;
    }
    // 3 m by 1.2 m in cells of 0.5 m.
    EXPECT_GE(onTheWall, 12U);
    EXPECT_LE(onTheWall, 21U);

    const std::vector<std::size_t> worst = worstRegions(residuals, 5, 0.01);
    ASSERT_EQ(worst.size(), 5U);
    for (const std::size_t i : worst) {
        EXPECT_THAT(regionInWords(residuals.regions[i]), HasSubstr("wall at x 4.0 m, y "));
        EXPECT_THAT(regionInWords(residuals.regions[i]), MatchesRegex(".*: off by (19|20|21) mm inwards"));
    }
    EXPECT_EQ(worstRegions(residuals, 100, 0.01).size(), onTheWall);
}

TEST(RegionResiduals, AWallMovedOutwardsIsNegative) {
    const RegionResiduals residuals = residualsOf(boxWithMovedWall(-0.015), Transform::Identity());
    const std::vector<std::size_t> worst = worstRegions(residuals, 1);
    ASSERT_EQ(worst.size(), 1U);
    EXPECT_NEAR(residuals.regions[worst[0]].offset_m, -0.015, 0.003);
    EXPECT_THAT(regionInWords(residuals.regions[worst[0]]), HasSubstr(" mm outwards"));
}

TEST(RegionResiduals, WhatTheMapDoesNotShowIsUnknownNotZero) {
    std::vector<Panel> panels = boxWithMovedWall(0.0);
    panels.pop_back();
    const RegionResiduals residuals = residualsOf(panels, Transform::Identity());
    const std::vector<double> offsets_m = residuals.offsetOfPoints_m();
    const std::vector<Eigen::Vector3d> reference = referenceOf(boxWithMovedWall(0.0));
    ASSERT_EQ(offsets_m.size(), reference.size());
    for (std::size_t i = 0; i < reference.size(); ++i) {
        const Eigen::Vector3d& point = reference[i];
        const bool inWall = point.y() > 0.3 && point.y() < 2.7 && point.z() > 0.3 && point.z() < 0.9;
        if (point.x() > 3.95 && inWall) {
            EXPECT_TRUE(std::isnan(offsets_m[i])) << point.transpose();
        }
        if (point.x() < 0.05 && inWall) {
            EXPECT_NEAR(offsets_m[i], 0.0, 0.003) << point.transpose();
        }
    }
    for (const RegionResidual& region : residuals.regions) {
        if (!region.isMeasured()) {
            EXPECT_THAT(regionInWords(region), HasSubstr("too little surface to measure"));
        }
    }
}

TEST(RegionResiduals, EmptyCloudsAndSizesThatAreNotPositiveAreErrors) {
    Progress progress;
    const std::vector<Eigen::Vector3d> none;
    const std::vector<Eigen::Vector3d> one{{0, 0, 0}};
    EXPECT_THROW(measureRegionResiduals(none, Transform::Identity(), one, {}, progress), Error);
    EXPECT_THROW(measureRegionResiduals(one, Transform::Identity(), none, {}, progress), Error);
    RegionResidualSettings settings;
    settings.cellSize_m = 0.0;
    EXPECT_THROW(measureRegionResiduals(one, Transform::Identity(), one, settings, progress), Error);
    const RegionResiduals single = measureRegionResiduals(one, Transform::Identity(), one, {}, progress);
    EXPECT_TRUE(std::isnan(single.offsetOfPoints_m()[0]));
}

}  // namespace
}  // namespace fodscope
