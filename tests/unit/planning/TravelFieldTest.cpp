// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "core/planning/CostMap.h"
#include "tests/fakes/PictureGrid.h"

namespace fodscope {
namespace {

CostMap pointRobotMap(const OccupancyGrid& grid) {
    CostMapSettings settings;
    settings.inscribedRadius_m = 0.0;
    settings.inflationRadius_m = 0.0;
    return inflate(grid, settings);
}

TEST(TravelField, goesStraightOverOpenFloor) {
    const CostMap costMap = pointRobotMap(walledRoom(60, 60));
    const Eigen::Vector2d start(0.31, 0.42);
    const Eigen::Vector2d goal(2.13, 1.87);
    const auto path = TravelField(costMap, start).pathTo(goal);
    ASSERT_TRUE(path);
    EXPECT_EQ(path->points_map.front(), start);
    EXPECT_EQ(path->points_map.back(), goal);
    EXPECT_EQ(path->points_map.size(), 2U);
    EXPECT_NEAR(path->length_m, (goal - start).norm(), 1e-12);
}

TEST(TravelField, goesRoundAWallByTheShorterEnd) {
    const CostMap costMap = pointRobotMap(pictureGrid(
        {
            ".......",
            ".......",
            "...#...",
            "...#...",
            "...#...",
            "...#...",
            "...#...",
            ".......",
        },
        1.0));
    const auto path = TravelField(costMap, {2.5, 1.5}).pathTo({4.5, 1.5});
    ASSERT_TRUE(path);
    // Round the lower end: down a cell, three across, up a cell.
    EXPECT_NEAR(path->length_m, 4.0, 1e-9);
    EXPECT_NEAR(*TravelField(costMap, {2.5, 1.5}).distanceTo({4.5, 1.5}), 4.0, 1e-6);
}

TEST(TravelField, keepsOffWallsWhereThereIsRoom) {
    // A dog-leg past an obstacle: the straight line would scrape the inscribed radius.
    OccupancyGrid grid = walledRoom(80, 60);
    for (int row = 0; row < 20; ++row)
        grid.cells[grid.offset({40, row})] = Cell::Occupied;
    CostMap costMap = inflate(grid, {});
    const auto path = TravelField(costMap, {1.2, 0.75}).pathTo({2.9, 0.75});
    ASSERT_TRUE(path);
    for (std::size_t i = 1; i < path->points_map.size(); ++i) {
        for (double share = 0.0; share <= 1.0; share += 0.01) {
            const Eigen::Vector2d place =
                path->points_map[i - 1] + share * (path->points_map[i] - path->points_map[i - 1]);
            EXPECT_LT(costMap.costAt(grid.cellAt(place)), 200);
        }
    }
}

TEST(TravelField, doesNotReachBehindWallsOrOutside) {
    const CostMap costMap = pointRobotMap(pictureGrid({"..#.."}, 1.0));
    const TravelField field(costMap, {0.5, 0.5});
    EXPECT_FALSE(field.pathTo({4.5, 0.5}));
    EXPECT_FALSE(field.pathTo({2.5, 0.5}));
    EXPECT_FALSE(field.pathTo({9.0, 0.5}));
    EXPECT_FALSE(field.pathTo({std::nan(""), 0.5}));
    EXPECT_FALSE(TravelField(costMap, {-5.0, 0.5}).pathTo({0.5, 0.5}));
}

TEST(TravelField, pathWithinOneCellIsTheStraightLine) {
    const CostMap costMap = pointRobotMap(pictureGrid({"..."}, 1.0));
    const auto path = TravelField(costMap, {0.2, 0.5}).pathTo({0.8, 0.5});
    ASSERT_TRUE(path);
    EXPECT_NEAR(path->length_m, 0.6, 1e-12);
    const auto standing = TravelField(costMap, {0.2, 0.5}).pathTo({0.2, 0.5});
    ASSERT_TRUE(standing);
    EXPECT_EQ(standing->length_m, 0.0);
}

TEST(TravelField, beginsBesideABlockedStart) {
    const CostMap costMap = pointRobotMap(pictureGrid({"....", ".#..", "...."}, 0.1));
    const auto path = TravelField(costMap, {0.17, 0.15}).pathTo({0.35, 0.15});
    ASSERT_TRUE(path);
    EXPECT_EQ(path->points_map.front(), Eigen::Vector2d(0.17, 0.15));
}

}  // namespace
}  // namespace fodscope
