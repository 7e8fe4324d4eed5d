// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/common/Error.h"
#include "core/planning/OccupancyGrid.h"
#include "tests/fakes/PictureGrid.h"

namespace fodscope {
namespace {

using Points = std::vector<Eigen::Vector3d>;

/// Floor at z, two points in each 5 cm cell, over x and y from 0.
Points floorOf(double length_m, double width_m, double z_m = 0.0) {
    Points points;
    for (double x = 0.0125; x < length_m; x += 0.025) {
        for (double y = 0.0125; y < width_m; y += 0.025)
            points.emplace_back(x, y, z_m);
    }
    return points;
}

Cell cellUnder(const OccupancyGrid& grid, double x_m, double y_m) {
    const CellIndex index = grid.cellAt({x_m, y_m});
    return grid.contains(index) ? grid.at(index) : Cell::Unknown;
}

TEST(OccupancyFromMap, takesTheHeightsOverTheReferencesFloor) {
    Points points = floorOf(1.0, 1.0, 0.5);
    const auto post = [&](double x, double height) {
        points.emplace_back(x, 0.52, 0.5 + height);
        points.emplace_back(x, 0.53, 0.5 + height);
    };
    post(0.22, 0.12);
    post(0.42, 0.14);
    post(0.62, 0.44);
    post(0.82, 0.47);
    const OccupancyGrid grid = occupancyFromMap(points, Transform::Identity(), 0.5, {});
    EXPECT_EQ(cellUnder(grid, 0.22, 0.52), Cell::Free);
    EXPECT_EQ(cellUnder(grid, 0.42, 0.52), Cell::Occupied);
    EXPECT_EQ(cellUnder(grid, 0.62, 0.52), Cell::Occupied);
    EXPECT_EQ(cellUnder(grid, 0.82, 0.52), Cell::Free);
    EXPECT_EQ(cellUnder(grid, -0.05, 0.5), Cell::Unknown);
}

TEST(OccupancyFromMap, heightsAreOfTheReferenceAndCellsOfTheMap) {
    // The map frame lies on its side: what is up in the reference is +y in the map.
    Transform T_reference_from_map = Transform::Identity();
    T_reference_from_map.linear() = Eigen::AngleAxisd(std::numbers::pi / 2.0, Eigen::Vector3d::UnitX()).matrix();
    const Points points{{0.51, 0.3, 0.0}, {0.52, 0.3, 0.0}, {0.11, 0.0, 0.0}};
    const OccupancyGrid grid = occupancyFromMap(points, T_reference_from_map, 0.0, {});
    EXPECT_EQ(cellUnder(grid, 0.51, 0.3), Cell::Occupied);
    EXPECT_EQ(cellUnder(grid, 0.11, 0.0), Cell::Free);
}

TEST(OccupancyFromMap, aSinglePointIsNoObstacle) {
    Points points = floorOf(1.0, 1.0);
    points.emplace_back(0.52, 0.52, 0.3);
    EXPECT_EQ(cellUnder(occupancyFromMap(points, Transform::Identity(), 0.0, {}), 0.52, 0.52), Cell::Free);
}

TEST(OccupancyFromMap, narrowGapsInTheFloorCloseAndWideOnesStayUnknown) {
    Points points;
    for (const auto& point : floorOf(3.0, 1.0)) {
        const bool narrow = point.x() > 1.0 && point.x() < 1.2;
        const bool wide = point.x() > 2.0 && point.x() < 2.5;
        if (!narrow && !wide) points.push_back(point);
    }
    const OccupancyGrid grid = occupancyFromMap(points, Transform::Identity(), 0.0, {});
    EXPECT_EQ(cellUnder(grid, 1.12, 0.5), Cell::Free);
    EXPECT_EQ(cellUnder(grid, 2.22, 0.5), Cell::Unknown);
    EXPECT_EQ(cellUnder(grid, 3.02, 0.5), Cell::Unknown) << "the floor does not grow outwards";
}

TEST(OccupancyFromMap, refusesWhatIsNoMapOfATank) {
    EXPECT_THROW(occupancyFromMap({}, Transform::Identity(), 0.0, {}), Error);
    const Points ceiling{{0.0, 0.0, 2.0}, {1.0, 0.0, 2.0}};
    EXPECT_THROW(occupancyFromMap(ceiling, Transform::Identity(), 0.0, {}), Error);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(occupancyFromMap(Points{{nan, nan, nan}}, Transform::Identity(), 0.0, {}), Error);
    const Points millimetres{{0.0, 0.0, 0.0}, {6000.0, 5000.0, 0.0}};
    EXPECT_THROW(occupancyFromMap(millimetres, Transform::Identity(), 0.0, {}), Error);
    OccupancySettings upsideDown;
    upsideDown.obstacleMaximumHeight_m = 0.0;
    EXPECT_THROW(occupancyFromMap(floorOf(1, 1), Transform::Identity(), 0.0, upsideDown), Error);
}

TEST(OccupancyFromMap, oneFloorPointMakesAGridWithOneFreeCell) {
    const OccupancyGrid grid = occupancyFromMap(Points{{0.02, 0.02, 0.0}}, Transform::Identity(), 0.0, {});
    EXPECT_EQ(cellUnder(grid, 0.02, 0.02), Cell::Free);
    EXPECT_EQ(std::count(grid.cells.begin(), grid.cells.end(), Cell::Free), 1);
}

TEST(OccupancyGrid, turnedOriginsAreHonoured) {
    const OccupancyGrid grid = pictureGrid({"...", "..#"}, 0.5, {2.0, 1.0, std::numbers::pi / 2.0});
    // Column 2, row 0 lies 1.25 m along +y and 0.25 m along −x of the origin.
    EXPECT_TRUE(grid.centreOf({2, 0}).isApprox(Eigen::Vector2d(1.75, 2.25)));
    EXPECT_EQ(grid.cellAt({1.75, 2.25}), (CellIndex{2, 0}));
    EXPECT_EQ(cellUnder(grid, 1.75, 2.25), Cell::Occupied);
}

TEST(OccupancyGrid, pointsFarOutsideAreOutside) {
    const OccupancyGrid grid = walledRoom(5, 5);
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double far : {1e300, -1e300, infinity, -infinity, std::nan("")}) {
        EXPECT_FALSE(grid.contains(grid.cellAt({far, 0.1})));
        EXPECT_FALSE(grid.contains(grid.cellAt({0.1, far})));
    }
}

TEST(WithoutCandidates, freesTheCellsUnderThePointsGrownByOne) {
    const OccupancyGrid grid = pictureGrid({"#######", "#######", "#######", "#######", "#######"}, 1.0);
    const OccupancyGrid freed = withoutCandidates(grid, Points{{2.5, 2.5, 0.1}, {6.9, 4.9, 0.0}, {50.0, 0.0, 0.0}});
    EXPECT_EQ(freed.cells, pictureGrid({"#####..", "#...#..", "#...###", "#...###", "#######"}, 1.0).cells);
    EXPECT_EQ(withoutCandidates(grid, {}).cells, grid.cells);
}

}  // namespace
}  // namespace fodscope
