// SPDX-License-Identifier: MIT
#include "core/planning/CostMap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "core/common/Error.h"
#include "tests/fakes/PictureGrid.h"

namespace fodscope {
namespace {

/// costmap_2d's inflation, cell by cell over all obstacles.
int bruteForceCost(const OccupancyGrid& grid, CellIndex cell, const CostMapSettings& settings) {
    double nearest_cells = 1e9;
    for (int row = 0; row < grid.height; ++row) {
        for (int column = 0; column < grid.width; ++column) {
            if (grid.at({column, row}) != Cell::Occupied) continue;
            nearest_cells = std::min(nearest_cells, std::hypot(column - cell.column, row - cell.row));
        }
    }
    int cost = 0;
    const double distance_m = nearest_cells * grid.resolution_m;
    if (nearest_cells <= std::ceil(settings.inflationRadius_m / grid.resolution_m)) {
        cost =
            static_cast<int>(252.0 * std::exp(-settings.costScalingFactor * (distance_m - settings.inscribedRadius_m)));
        if (distance_m <= settings.inscribedRadius_m) cost = 253;
        if (nearest_cells == 0.0) cost = 254;
    }
    return grid.at(cell) == Cell::Unknown && cost < 253 ? 255 : cost;
}

TEST(CostMap, equalsTheFormulaInEveryCell) {
    std::mt19937 random(11);
    std::discrete_distribution<int> kind({0.96, 0.01, 0.03});
    for (const double resolution_m : {0.05, 0.025, 0.1}) {
        OccupancyGrid grid = walledRoom(50, 37, resolution_m);
        for (Cell& cell : grid.cells) {
            if (cell == Cell::Free) cell = static_cast<Cell>(kind(random));
        }
        const CostMap costMap = inflate(grid, {});
        for (int row = 0; row < grid.height; ++row) {
            for (int column = 0; column < grid.width; ++column) {
                ASSERT_EQ(costMap.costAt({column, row}), bruteForceCost(grid, {column, row}, {}))
                    << column << ", " << row << " at " << resolution_m << " m";
            }
        }
    }
}

TEST(CostMap, equalsTheCostsThatScipyWorksOutFromTheFormula) {
    std::ifstream file(std::filesystem::path(FODSCOPE_TEST_DATA) / "costmap" / "costs.csv");
    std::string line;
    OccupancyGrid grid;
    CostMapSettings settings;
    std::vector<int> expected;
    int grids = 0;
    const auto compare = [&] {
        if (expected.empty()) return;
        const CostMap costMap = inflate(grid, settings);
        for (std::size_t cell = 0; cell < expected.size(); ++cell)
            ASSERT_EQ(int{costMap.costs[cell]}, expected[cell]) << "cell " << cell << " of grid " << grids;
        ++grids;
    };
    while (std::getline(file, line)) {
        std::istringstream words(line);
        std::string word;
        if (line.starts_with("grid,")) {
            compare();
            grid = OccupancyGrid();
            expected.clear();
            char comma = ',';
            words.ignore(5);
            words >> grid.resolution_m >> comma >> settings.inscribedRadius_m >> comma >> settings.inflationRadius_m >>
                comma >> settings.costScalingFactor;
            continue;
        }
        grid.width = 0;
        for (; std::getline(words, word, ','); ++grid.width) {
            grid.cells.push_back(word[0] == '#' ? Cell::Occupied : word[0] == '.' ? Cell::Free : Cell::Unknown);
            expected.push_back(std::stoi(word.substr(2)));
        }
        ++grid.height;
    }
    compare();
    EXPECT_EQ(grids, 12);
}

TEST(CostMap, hasThePublishedValuesBesideAWall) {
    // One occupied column at x = 0, free floor to the right, 0.05 m: worked out by hand from costmap_2d's formula.
    const CostMap costMap = inflate(pictureGrid({"#............."}), {});
    const std::vector<std::uint8_t> expected{254, 253, 253, 253, 253, 178, 108, 65, 39, 24, 14, 0, 0, 0};
    EXPECT_EQ(costMap.costs, expected);
}

TEST(CostMap, unknownStaysUnknownUnlessTheRobotWouldTouchTheWall) {
    const CostMap costMap = inflate(pictureGrid({"#????????????."}), {});
    EXPECT_EQ(costMap.costAt({4, 0}), kCostInscribed);
    EXPECT_EQ(costMap.costAt({5, 0}), kCostUnknown);
    EXPECT_EQ(costMap.costAt({13, 0}), kCostFree);
}

TEST(CostMap, percentFollowsTheOccupancyGridTranslation) {
    EXPECT_EQ(costPercent(0), 0.0);
    EXPECT_EQ(costPercent(1), 1.0);
    EXPECT_EQ(costPercent(127), 49.0);
    EXPECT_EQ(costPercent(252), 98.0);
    EXPECT_EQ(costPercent(253), 99.0);
    EXPECT_EQ(costPercent(254), 100.0);
}

TEST(CostMap, refusesGridsAndSettingsThatMakeNoSense) {
    EXPECT_THROW(inflate(OccupancyGrid{}, {}), Error);
    OccupancyGrid torn = walledRoom(5, 5);
    torn.cells.pop_back();
    EXPECT_THROW(inflate(torn, {}), Error);
    OccupancyGrid flat = walledRoom(5, 5);
    flat.resolution_m = 0.0;
    EXPECT_THROW(inflate(flat, {}), Error);
    CostMapSettings negative;
    negative.inflationRadius_m = -1.0;
    EXPECT_THROW(inflate(walledRoom(5, 5), negative), Error);
    CostMapSettings notANumber;
    notANumber.costScalingFactor = std::nan("");
    EXPECT_THROW(inflate(walledRoom(5, 5), notANumber), Error);
}

CostMapSettings pointRobot() {
    CostMapSettings settings;
    settings.inscribedRadius_m = 0.0;
    settings.inflationRadius_m = 0.0;
    return settings;
}

TEST(FloodFill, staysOnTheRobotsSideOfAWallAndDoesNotSlipThroughCorners) {
    CostMap costMap = inflate(pictureGrid({"...#...", "...#...", "..#....", ".#....."}, 1.0), pointRobot());
    floodFill(costMap, {0.5, 3.5, 0.0});
    EXPECT_TRUE(costMap.isReachable({2, 3}));
    EXPECT_TRUE(costMap.isReachable({0, 0}));
    EXPECT_FALSE(costMap.isReachable({2, 0}));
    EXPECT_FALSE(costMap.isReachable({6, 3}));
    EXPECT_FALSE(costMap.isReachable({3, 3}));
    EXPECT_FALSE(costMap.isReachable({-1, 0}));
}

TEST(FloodFill, doesNotEnterUnknownFloor) {
    CostMap costMap = inflate(pictureGrid({"..?.."}, 1.0), pointRobot());
    floodFill(costMap, {0.5, 0.5, 0.0});
    EXPECT_TRUE(costMap.isReachable({1, 0}));
    EXPECT_FALSE(costMap.isReachable({2, 0}));
    EXPECT_FALSE(costMap.isReachable({4, 0}));
}

TEST(FloodFill, startsBesideAPointUnderTheRobot) {
    CostMap costMap = inflate(pictureGrid({"....", ".#..", "...."}, 0.1), pointRobot());
    floodFill(costMap, {0.17, 0.15, 0.0});
    EXPECT_TRUE(costMap.isReachable({2, 1}));
    EXPECT_TRUE(costMap.isReachable({0, 0}));
}

TEST(FloodFill, saysWhenTheRobotCannotStandThere) {
    CostMap room = inflate(walledRoom(20, 20), {});
    EXPECT_THROW(floodFill(room, {-3.0, 0.0, 0.0}), Error);
    EXPECT_THROW(floodFill(room, {std::nan(""), 0.0, 0.0}), Error);
    CostMap solid = inflate(pictureGrid({"#####", "#####"}), {});
    EXPECT_THROW(floodFill(solid, {0.1, 0.05, 0.0}), Error);
    CostMap unknown = inflate(pictureGrid({"?????", "?????"}), {});
    EXPECT_THROW(floodFill(unknown, {0.1, 0.05, 0.0}), Error);
    CostMap empty;
    EXPECT_THROW(floodFill(empty, {}), Error);
}

TEST(FloodFill, worksOnAGridOfOneCell) {
    CostMap costMap = inflate(pictureGrid({"."}), {});
    floodFill(costMap, {0.02, 0.02, 0.0});
    EXPECT_TRUE(costMap.isReachable({0, 0}));
}

}  // namespace
}  // namespace fodscope
