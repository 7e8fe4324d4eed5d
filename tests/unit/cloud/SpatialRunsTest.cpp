// SPDX-License-Identifier: MIT
#include "core/cloud/SpatialRuns.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/cloud/HilbertCurve.h"
#include "core/cloud/PointBox.h"
#include "tests/unit/cloud/RandomPoints.h"

namespace fodscope {
namespace {

constexpr std::size_t kMost = 64;

SpatialRuns checkedRuns(const std::vector<Eigen::Vector3d>& points) {
    const SpatialRuns runs = spatialRuns(points, kMost, Progress());
    std::vector<std::uint32_t> all(points.size());
    std::iota(all.begin(), all.end(), 0U);
    std::vector<std::uint32_t> sorted = runs.order;
    std::ranges::sort(sorted);
    EXPECT_EQ(sorted, all);
    EXPECT_EQ(runs.ends.back(), points.size());
    for (std::size_t run = 0; run < runs.count(); ++run) {
        EXPECT_GE(runs.run(run).size(), 1U);
        EXPECT_LE(runs.run(run).size(), kMost);
    }
    return runs;
}

double meanDiagonal(const std::vector<Eigen::Vector3d>& points, const SpatialRuns& runs) {
    double sum = 0.0;
    for (std::size_t run = 0; run < runs.count(); ++run) {
        PointBox box;
        for (const std::uint32_t index : runs.run(run))
            box.add(points[index]);
        sum += (box.high - box.low).norm();
    }
    return sum / static_cast<double>(runs.count());
}

TEST(HilbertCurve, StepsFromCellToNeighbouringCellThroughAllOfThem) {
    for (int bits = 1; bits <= 5; ++bits) {
        const std::uint32_t side = 1U << bits;
        const std::vector<std::uint16_t> ranks = hilbertRanks(bits);
        std::vector<std::uint32_t> cellAt(ranks.size(), side * side * side);
        for (std::uint32_t cell = 0; cell < ranks.size(); ++cell)
            cellAt.at(ranks[cell]) = cell;
        for (std::size_t i = 1; i < cellAt.size(); ++i) {
            const auto along = [&](std::uint32_t cell, std::uint32_t step) {
                return static_cast<int>(cell / step % side);
            };
            int steps = 0;
            for (const std::uint32_t step : {1U, side, side * side})
                steps += std::abs(along(cellAt[i], step) - along(cellAt[i - 1], step));
            ASSERT_EQ(steps, 1) << "bits " << bits << ", rank " << i;
        }
    }
}

TEST(SpatialRuns, AreCompactAndWellFilled) {
    const auto points = randomPoints(100000, 31);
    const SpatialRuns runs = checkedRuns(points);
    EXPECT_LT(runs.count(), 2.5 * 100000.0 / kMost);
    // A cube of 64 points has a diagonal of 0.15.
    EXPECT_LT(meanDiagonal(points, runs), 0.2);
}

TEST(SpatialRuns, DivideLumpsWithinLumps) {
    // Half of the points in an eighth of the length, half of these in an eighth of that, and so on, and a stray one.
    auto points = randomPoints(4096, 32);
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] *= std::pow(0.125, std::floor(std::log2(4096.0 / static_cast<double>(i + 1))));
    points.emplace_back(1e9, -1e9, 1e9);
    checkedRuns(points);
}

TEST(SpatialRuns, TakeAnyCoordinates) {
    auto far = randomPoints(3000, 33);
    for (std::size_t i = 0; i < far.size(); ++i)
        far[i] *= std::pow(10.0, static_cast<double>(i % 600) - 300.0);
    checkedRuns(far);
    auto opposite = randomPoints(1000, 34);
    for (Eigen::Vector3d& point : opposite)
        point = (point.array() - 0.5) * 2.0 * std::numeric_limits<double>::max();
    checkedRuns(opposite);
    auto tiny = randomPoints(1000, 35);
    for (Eigen::Vector3d& point : tiny)
        point *= std::numeric_limits<double>::denorm_min() * 1000.0;
    checkedRuns(tiny);
    checkedRuns(std::vector<Eigen::Vector3d>(1000, Eigen::Vector3d(1.0, 2.0, 3.0)));
    auto piles = randomPoints(1000, 36);
    for (std::size_t i = 0; i < piles.size(); ++i)
        piles[i] = i % 10 == 0 ? piles[i] : piles[0];
    checkedRuns(piles);
}

TEST(SpatialRuns, DoNotDependOnTheNumberOfThreads) {
    const auto points = randomPoints(200000, 37);
    const SpatialRuns runs = spatialRuns(points, 2048, Progress());
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const SpatialRuns again = spatialRuns(points, 2048, Progress());
    EXPECT_EQ(runs.order, again.order);
    EXPECT_EQ(runs.ends, again.ends);
}

TEST(SpatialRuns, StopWhenCancelled) {
    Progress progress;
    progress.cancel();
    EXPECT_THROW(spatialRuns(randomPoints(1000, 38), kMost, progress), Cancelled);
}

}  // namespace
}  // namespace fodscope
