// SPDX-License-Identifier: MIT
#include "core/cloud/NeighbourIndex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>

#include "core/common/Error.h"
#include "tests/unit/cloud/RandomPoints.h"

namespace fodscope {
namespace {

std::vector<Neighbour> bruteForce(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& query) {
    std::vector<Neighbour> all;
    for (std::size_t i = 0; i < points.size(); ++i)
        all.push_back({static_cast<std::uint32_t>(i), (points[i] - query).squaredNorm()});
    std::stable_sort(all.begin(), all.end(), [](const Neighbour& a, const Neighbour& b) {
        return a.squaredDistance_m2 < b.squaredDistance_m2;
    });
    return all;
}

std::vector<std::uint32_t> indices(std::span<const Neighbour> neighbours) {
    std::vector<std::uint32_t> result;
    for (const Neighbour& neighbour : neighbours)
        result.push_back(neighbour.index);
    return result;
}

/// A lattice: nearly every query point has ties.
std::vector<Eigen::Vector3d> lattice(int edge) {
    std::vector<Eigen::Vector3d> points;
    for (int x = 0; x < edge; ++x)
        for (int y = 0; y < edge; ++y)
            for (int z = 0; z < edge; ++z)
                points.emplace_back(x, y, z);
    return points;
}

TEST(NeighbourIndex, AgreesWithBruteForceOnRandomPoints) {
    const auto points = randomPoints(700, 1);
    const NeighbourIndex index(points);
    for (const Eigen::Vector3d& query : randomPoints(50, 2)) {
        auto expected = bruteForce(points, query);
        EXPECT_EQ(index.nearest(query).index, expected.front().index);
        EXPECT_DOUBLE_EQ(index.nearest(query).squaredDistance_m2, expected.front().squaredDistance_m2);
        std::vector<Neighbour> within;
        for (const Neighbour& neighbour : expected)
            if (neighbour.squaredDistance_m2 <= 0.04) within.push_back(neighbour);
        EXPECT_EQ(indices(index.withinRadius(query, 0.2)), indices(within));
        expected.resize(37);
        EXPECT_EQ(indices(index.kNearest(query, 37)), indices(expected));
    }
}

TEST(NeighbourIndex, GivesTiesToTheLowerIndex) {
    auto points = lattice(7);
    std::reverse(points.begin(), points.end());
    const NeighbourIndex index(points);
    std::vector<Eigen::Vector3d> queries = points;
    for (Eigen::Vector3d& query : queries)
        query.array() += 0.5;
    queries.insert(queries.end(), points.begin(), points.end());
    for (const Eigen::Vector3d& query : queries) {
        auto expected = bruteForce(points, query);
        EXPECT_EQ(index.nearest(query).index, expected.front().index);
        expected.resize(10);
        ASSERT_EQ(indices(index.kNearest(query, 10)), indices(expected));
    }
}

/// Clouds that are hard on a tree: a stray point far away, two dense lumps, a line, thousands of points in few places.
std::vector<std::vector<Eigen::Vector3d>> difficultClouds() {
    std::vector<std::vector<Eigen::Vector3d>> clouds;
    auto stray = randomPoints(900, 11);
    stray.emplace_back(1e9, -1e9, 1e9);
    clouds.push_back(stray);
    auto lumps = randomPoints(400, 12);
    for (const Eigen::Vector3d& point : randomPoints(400, 13))
        lumps.push_back(1e-4 * point + Eigen::Vector3d(50.0, 0.0, 0.0));
    clouds.push_back(lumps);
    std::vector<Eigen::Vector3d> line;
    for (int i = 0; i < 500; ++i)
        line.emplace_back(0.01 * i, 0.0, 0.0);
    clouds.push_back(line);
    std::vector<Eigen::Vector3d> piles;
    for (int i = 0; i < 1500; ++i)
        piles.emplace_back(i % 3, 0.0, 0.0);
    clouds.push_back(piles);
    return clouds;
}

TEST(NeighbourIndex, AgreesWithBruteForceOnDifficultClouds) {
    for (const auto& points : difficultClouds()) {
        const NeighbourIndex index(points);
        std::vector<Eigen::Vector3d> queries = randomPoints(20, 14);
        for (std::size_t i = 0; i < points.size(); i += 41)
            queries.push_back(points[i]);
        for (const std::size_t k : {1U, 2U, 50U, 450U}) {
            std::vector<std::vector<std::uint32_t>> found(queries.size());
            Progress progress;
            index.forEachKNearest(
                queries, k,
                [&](std::size_t i, std::span<const Neighbour> neighbours) { found[i] = indices(neighbours); },
                progress);
            for (std::size_t i = 0; i < queries.size(); ++i) {
                auto expected = bruteForce(points, queries[i]);
                expected.resize(std::min(k, expected.size()));
                ASSERT_EQ(found[i], indices(expected)) << "query " << i << ", k " << k;
            }
        }
    }
}

TEST(NeighbourIndex, FindsCoincidentPointsInOrder) {
    const std::vector<Eigen::Vector3d> points(1000, Eigen::Vector3d(1.0, 2.0, 3.0));
    const NeighbourIndex index(points);
    EXPECT_EQ(index.nearest(points[0]).index, 0u);
    EXPECT_EQ(indices(index.kNearest(points[0], 3)), (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(index.withinRadius(points[0], 0.0).size(), 1000u);
}

TEST(NeighbourIndex, ReturnsAllPointsWhenAskedForMore) {
    const auto points = randomPoints(5, 3);
    const NeighbourIndex index(points);
    EXPECT_EQ(index.kNearest(points[2], 50).size(), 5u);
    EXPECT_EQ(index.kNearest(points[2], 50).front().index, 2u);
    EXPECT_TRUE(index.kNearest(points[2], 0).empty());
}

TEST(NeighbourIndex, AnswersEveryQueryOnceInParallel) {
    const auto points = randomPoints(3000, 4);
    const auto queries = randomPoints(20000, 5);
    const NeighbourIndex index(points);
    Progress progress;
    const auto nearest = index.nearestOfEach(queries, progress);
    std::vector<int> calls(queries.size());
    index.forEachKNearest(
        queries, 4,
        [&](std::size_t i, std::span<const Neighbour> neighbours) {
            ++calls[i];
            EXPECT_EQ(neighbours.size(), 4u);
            EXPECT_EQ(neighbours.front().index, nearest[i].index);
        },
        progress);
    EXPECT_TRUE(std::all_of(calls.begin(), calls.end(), [](int count) { return count == 1; }));
}

TEST(NeighbourIndex, StopsWhenCancelled) {
    const auto points = randomPoints(1000, 6);
    const NeighbourIndex index(points);
    Progress progress;
    progress.cancel();
    EXPECT_THROW(index.nearestOfEach(points, progress), Cancelled);
}

TEST(NeighbourIndex, RefusesNoPointsAndPointsThatAreNotFinite) {
    EXPECT_THROW(NeighbourIndex(std::vector<Eigen::Vector3d>{}), Error);
    const std::vector<Eigen::Vector3d> points{{0.0, 0.0, std::numeric_limits<double>::quiet_NaN()}};
    EXPECT_THROW(NeighbourIndex{points}, Error);
}

}  // namespace
}  // namespace fodscope
