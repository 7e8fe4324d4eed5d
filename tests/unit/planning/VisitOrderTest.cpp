// SPDX-License-Identifier: MIT
#include "core/planning/VisitOrder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "tests/fakes/PictureGrid.h"

namespace fodscope {
namespace {

Eigen::MatrixXd randomDistances(int places, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(0.0, 10.0);
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i < places; ++i)
        points.emplace_back(coordinate(random), coordinate(random));
    Eigen::MatrixXd lengths(places, places);
    for (int i = 0; i < places; ++i)
        for (int j = 0; j < places; ++j)
            lengths(i, j) = (points[static_cast<std::size_t>(i)] - points[static_cast<std::size_t>(j)]).norm();
    return lengths;
}

double shortestOfAllOrders(const Eigen::MatrixXd& lengths) {
    std::vector<std::size_t> order(static_cast<std::size_t>(lengths.rows()) - 1);
    std::iota(order.begin(), order.end(), std::size_t{1});
    double least = 1e9;
    do {
        least = std::min(least, lengthOf(order, lengths));
    } while (std::next_permutation(order.begin(), order.end()));
    return least;
}

bool visitsEachOnce(std::vector<std::size_t> order, int places) {
    std::ranges::sort(order);
    std::vector<std::size_t> all(static_cast<std::size_t>(places) - 1);
    std::iota(all.begin(), all.end(), std::size_t{1});
    return order == all;
}

TEST(VisitOrder, isTheShortestOfAllOrdersOfAFewPlaces) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Eigen::MatrixXd lengths = randomDistances(8, seed);
        const auto order = shortestOrder(lengths);
        EXPECT_TRUE(visitsEachOnce(order, 8));
        EXPECT_NEAR(lengthOf(order, lengths), shortestOfAllOrders(lengths), 1e-9);
    }
}

TEST(VisitOrder, theNearestNextIsThePapersChoiceEachTime) {
    Eigen::MatrixXd lengths(4, 4);
    // Places on a line at 0, −1, 1.5 and 4: the nearest first, then back over the start.
    const double at[] = {0.0, -1.0, 1.5, 4.0};
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            lengths(i, j) = std::abs(at[i] - at[j]);
    EXPECT_EQ(nearestNextOrder(lengths), (std::vector<std::size_t>{1, 2, 3}));
    EXPECT_DOUBLE_EQ(lengthOf(nearestNextOrder(lengths), lengths), 6.0);
    EXPECT_DOUBLE_EQ(lengthOf(shortestOrder(lengths), lengths), 6.0);
}

TEST(VisitOrder, manyPlacesAreNeverALongerTourThanNearestNextAndMostlyMuchShorter) {
    double nearest = 0.0, shortest = 0.0;
    for (unsigned seed = 0; seed < 8; ++seed) {
        const Eigen::MatrixXd lengths = randomDistances(45, seed);
        const auto order = shortestOrder(lengths);
        EXPECT_TRUE(visitsEachOnce(order, 45));
        EXPECT_EQ(shortestOrder(lengths), order);
        const double before = lengthOf(nearestNextOrder(lengths), lengths);
        EXPECT_LE(lengthOf(order, lengths), before + 1e-9);
        nearest += before;
        shortest += lengthOf(order, lengths);
    }
    EXPECT_LT(shortest, 0.9 * nearest);
}

TEST(VisitOrder, noPlaceAndOnePlaceAreOrdersToo) {
    EXPECT_TRUE(shortestOrder(Eigen::MatrixXd::Zero(1, 1)).empty());
    EXPECT_EQ(shortestOrder(Eigen::MatrixXd::Constant(2, 2, 3.0)), std::vector<std::size_t>{1});
    EXPECT_TRUE(nearestNextOrder(Eigen::MatrixXd()).empty());
}

TEST(VisitLegs, areTheDrivesRoundTheWallsBothWays) {
    OccupancyGrid grid = walledRoom(80, 80);
    for (int row = 0; row < 60; ++row)
        grid.cells[grid.offset({40, row})] = Cell::Occupied;
    CostMap costMap = inflate(grid, {});
    floodFill(costMap, {1.0, 1.0, 0.0});
    Progress progress;
    const std::vector<Eigen::Vector2d> places{{1.0, 1.0}, {3.0, 1.0}, {1.0, 3.0}};
    const VisitLegs legs(costMap, places, progress);
    const TravelField field(costMap, places[0]);
    EXPECT_EQ(legs.lengths_m()(0, 1), field.pathTo(places[1])->length_m);
    EXPECT_GT(legs.lengths_m()(0, 1), 4.0);
    EXPECT_EQ(legs.lengths_m()(1, 0), legs.lengths_m()(0, 1));
    const DrivePath there = legs.drive(0, 2), back = legs.drive(2, 0);
    EXPECT_EQ(there.points_map.front(), places[0]);
    EXPECT_EQ(there.points_map.back(), places[2]);
    EXPECT_EQ(back.points_map.front(), places[2]);
    EXPECT_EQ(back.length_m, there.length_m);
    progress.cancel();
    EXPECT_THROW(VisitLegs(costMap, places, progress), Cancelled);
}

}  // namespace
}  // namespace fodscope
