// SPDX-License-Identifier: MIT
#include "core/cloud/NeighbourIndex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>
#include <utility>

#include "core/cloud/BlockKernels.h"
#include "core/common/Error.h"
#include "tests/unit/cloud/RandomPoints.h"

namespace fodscope {
namespace {

/// All points, nearest first; of those at the same distance the one with the lower index first.
std::vector<Neighbour> bruteForce(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& query) {
    std::vector<Neighbour> all;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector3d d = points[i] - query;
        all.push_back({static_cast<std::uint32_t>(i), (d.x() * d.x() + d.y() * d.y()) + d.z() * d.z()});
    }
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

std::vector<Eigen::Vector3d> shifted(std::vector<Eigen::Vector3d> points, double scale, const Eigen::Vector3d& shift) {
    for (Eigen::Vector3d& point : points)
        point = scale * point + shift;
    return points;
}

/// As a file would hold them.
std::vector<Eigen::Vector3d> asFloats(std::vector<Eigen::Vector3d> points) {
    for (Eigen::Vector3d& point : points)
        point = point.cast<float>().cast<double>();
    return points;
}

/// A wall of a tank, with noise across it.
std::vector<Eigen::Vector3d> surface(std::size_t count, std::uint64_t seed) {
    auto points = randomPoints(count, seed);
    for (Eigen::Vector3d& point : points)
        point.z() *= 0.01;
    return points;
}

/// Clouds that are hard on a tree: few points, a stray point far away, two dense lumps, a line, thousands of points in
/// few places, ties everywhere, large coordinates, and distances whose squares are no longer numbers.
std::vector<std::vector<Eigen::Vector3d>> difficultClouds() {
    std::vector<std::vector<Eigen::Vector3d>> clouds;
    for (std::size_t count = 1; count <= 40; ++count)
        clouds.push_back(randomPoints(count, 100 + count));
    clouds.push_back(asFloats(surface(3000, 10)));
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
    auto ties = lattice(9);
    std::reverse(ties.begin(), ties.end());
    clouds.push_back(ties);
    clouds.push_back(shifted(surface(1000, 15), 10.0, {6.1e5, 5.3e6, -40.0}));
    clouds.push_back(shifted(surface(1000, 16), 1e300, {0.0, 0.0, 0.0}));
    clouds.push_back(shifted(surface(1000, 17), 1e-300, {0.0, 0.0, 0.0}));
    auto hostile = surface(300, 18);
    hostile.emplace_back(1e300, 0.0, 0.0);
    hostile.emplace_back(0.0, -1e300, 1e300);
    hostile.emplace_back(1e39, 0.0, 0.0);
    clouds.push_back(hostile);
    // More than one run of blocks.
    clouds.push_back(asFloats(surface(20000, 19)));
    auto dense = surface(12000, 20);
    for (std::size_t i = 0; i < dense.size(); i += 2)
        dense[i] = dense[0] + 1e-5 * dense[i];
    clouds.push_back(dense);
    return clouds;
}

bool areSame(std::span<const Neighbour> a, std::span<const Neighbour> b) {
    return std::ranges::equal(a, b, [](const Neighbour& x, const Neighbour& y) {
        return x.index == y.index && x.squaredDistance_m2 == y.squaredDistance_m2;
    });
}

/// Every way to ask, with either kind of inner loops.
class EveryQuery : public testing::TestWithParam<const BlockKernels*> {
  protected:
    void SetUp() override {
        if (GetParam() == nullptr) GTEST_SKIP() << "this processor has no AVX2";
    }

    void compare(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& queries,
                 std::size_t stride) {
        Progress progress;
        const NeighbourIndex index(points, progress, *GetParam());
        const std::vector<Neighbour> nearest = index.nearestOfEach(queries, progress);
        constexpr std::array<std::size_t, 5> ks{1, 2, 50, 90, 450};
        std::array<std::vector<std::vector<Neighbour>>, 5> found;
        for (std::size_t i = 0; i < ks.size(); ++i) {
            found[i].resize(queries.size());
            index.forEachKNearest(
                queries, ks[i],
                [&](std::size_t q, std::span<const Neighbour> near) { found[i][q].assign(near.begin(), near.end()); },
                progress);
        }
        for (std::size_t q = 0; q < queries.size(); q += stride) {
            const std::vector<Neighbour> all = bruteForce(points, queries[q]);
            ASSERT_TRUE(areSame(std::span(&nearest[q], 1), std::span(all).first(1))) << "query " << q;
            const Neighbour one = index.nearest(queries[q]);
            ASSERT_TRUE(areSame(std::span(&one, 1), std::span(all).first(1))) << "query " << q;
            for (std::size_t i = 0; i < ks.size(); ++i) {
                const auto expected = std::span(all).first(std::min(ks[i], all.size()));
                ASSERT_TRUE(areSame(found[i][q], expected)) << "query " << q << ", k " << ks[i];
                ASSERT_TRUE(areSame(index.kNearest(queries[q], ks[i]), expected)) << "query " << q << ", k " << ks[i];
            }
            compareBall(index, all, queries[q]);
        }
    }

  private:
    static void compareBall(const NeighbourIndex& index, std::span<const Neighbour> all, const Eigen::Vector3d& query) {
        Progress progress;
        const double radius_m = std::sqrt(all[std::min<std::size_t>(all.size() - 1, 70)].squaredDistance_m2);
        const double limit_m2 = std::min(radius_m * radius_m, std::numeric_limits<double>::max());
        const auto end = std::ranges::find_if(all, [&](const Neighbour& n) { return n.squaredDistance_m2 > limit_m2; });
        const auto expected = all.first(static_cast<std::size_t>(end - all.begin()));
        ASSERT_TRUE(areSame(index.withinRadius(query, radius_m), expected));
        index.forEachWithinRadius(
            std::span(&query, 1), radius_m,
            [&](std::size_t, std::span<const Neighbour> near) {
                std::vector<Neighbour> sorted(near.begin(), near.end());
                std::ranges::sort(sorted, {},
                                  [](const Neighbour& n) { return std::pair(n.squaredDistance_m2, n.index); });
                EXPECT_TRUE(areSame(sorted, expected));
            },
            progress);
    }
};

TEST_P(EveryQuery, AgreesWithBruteForceToTheBit) {
    for (const auto& points : difficultClouds()) {
        std::vector<Eigen::Vector3d> queries = randomPoints(20, 14);
        for (std::size_t i = 0; i < points.size(); i += 41)
            queries.push_back(points[i]);
        queries.push_back(0.5 * points.front() + 0.5 * points.back());
        ASSERT_NO_FATAL_FAILURE(compare(points, queries, points.size() < 10000 ? 1 : 29));
    }
}

TEST_P(EveryQuery, AgreesWithBruteForceWhenAskedForItsOwnPoints) {
    for (const auto& points : difficultClouds())
        ASSERT_NO_FATAL_FAILURE(compare(points, points, 1 + points.size() / 23));
}

TEST_P(EveryQuery, AgreesWithBruteForceForAsManyOtherQueriesAsItHasPoints) {
    const auto points = surface(3000, 41);
    auto almost = points;
    almost[1234].x() += 0.25;
    ASSERT_NO_FATAL_FAILURE(compare(points, almost, 1234));
    ASSERT_NO_FATAL_FAILURE(compare(points, surface(3000, 42), 31));
}

INSTANTIATE_TEST_SUITE_P(NeighbourIndex, EveryQuery, testing::Values(&plainKernels(), avx2Kernels()),
                         [](const auto& kernels) { return kernels.index == 0 ? "Plainly" : "WithAvx2"; });

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
    EXPECT_THROW(NeighbourIndex(points, progress), Cancelled);
}

TEST(NeighbourIndex, ReportsOnTheCallingThreadAndNeverBackwards) {
    const auto points = randomPoints(50000, 7);
    const std::thread::id caller = std::this_thread::get_id();
    double last = -1.0;
    Progress progress([&](const std::string& stage, double fraction) {
        EXPECT_EQ(stage, "looking");
        EXPECT_EQ(std::this_thread::get_id(), caller);
        EXPECT_GE(fraction, last);
        last = fraction;
    });
    NeighbourIndex(points).nearestOfEach(points, progress, "looking");
    EXPECT_EQ(last, 1.0);
}

TEST(NeighbourIndex, StopsWhereItStandsWhenCancelled) {
    const auto points = randomPoints(50000, 8);
    const NeighbourIndex index(points);
    Progress progress;
    std::atomic<int> calls = 0;
    EXPECT_THROW(index.forEachKNearest(
                     points, 5,
                     [&](std::size_t, std::span<const Neighbour>) {
                         if (++calls == 100) progress.cancel();
                     },
                     progress),
                 Cancelled);
    EXPECT_LT(calls, 50000);
}

TEST(NeighbourIndex, RefusesNoPointsAndPointsThatAreNotFinite) {
    EXPECT_THROW(NeighbourIndex(std::vector<Eigen::Vector3d>{}), Error);
    const std::vector<Eigen::Vector3d> points{{0.0, 0.0, std::numeric_limits<double>::quiet_NaN()}};
    EXPECT_THROW(NeighbourIndex{points}, Error);
}

}  // namespace
}  // namespace fodscope
