// SPDX-License-Identifier: MIT
#include "core/cloud/Smoothing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "core/cloud/RandomSample.h"
#include "core/common/Error.h"
#include "tests/unit/cloud/ExpectError.h"
#include "tests/unit/cloud/RandomPoints.h"

namespace fodscope {
namespace {

SmoothingSettings ball(double radius_m) {
    SmoothingSettings settings;
    settings.neighbourhood = SmoothingNeighbourhood::Ball;
    settings.radius_m = radius_m;
    return settings;
}

std::vector<std::vector<std::uint32_t>> neighbourhoods(const std::vector<Eigen::Vector3d>& points,
                                                       const std::vector<Eigen::Vector3d>& places,
                                                       const SmoothingSettings& settings) {
    std::vector<std::vector<std::uint32_t>> found(places.size());
    Progress progress;
    const NeighbourIndex index(points);
    forEachNeighbourhood(
        index, places, settings, "test",
        [&](std::size_t i, std::span<const Neighbour> near) {
            for (const Neighbour& neighbour : near)
                found[i].push_back(neighbour.index);
        },
        progress);
    return found;
}

TEST(Smoothing, ABallHoldsAllPointsUpToItsRadiusAndNoOther) {
    const auto points = randomPoints(800, 41);
    const auto places = randomPoints(60, 42);
    auto found = neighbourhoods(points, places, ball(0.25));
    for (std::size_t i = 0; i < places.size(); ++i) {
        std::vector<std::uint32_t> expected;
        for (std::uint32_t j = 0; j < points.size(); ++j)
            if ((points[j] - places[i]).squaredNorm() <= 0.25 * 0.25) expected.push_back(j);
        std::sort(found[i].begin(), found[i].end());
        EXPECT_EQ(found[i], expected);
    }
}

TEST(Smoothing, APointExactlyAtTheRadiusBelongsToTheBall) {
    const std::vector<Eigen::Vector3d> points{{0.0, 0.0, 0.0}, {0.25, 0.0, 0.0}, {0.5, 0.0, 0.0}};
    EXPECT_EQ(neighbourhoods(points, {{0.0, 0.0, 0.0}}, ball(0.25)).front().size(), 2u);
}

TEST(Smoothing, AnEmptyBallIsHandedOverAsOne) {
    const std::vector<Eigen::Vector3d> points{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    const auto found = neighbourhoods(points, {{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}, ball(0.1));
    EXPECT_TRUE(found[0].empty());
    EXPECT_EQ(found[1].size(), 2u);
}

TEST(Smoothing, MoreNeighboursThanThereAreAreAllOfThem) {
    SmoothingSettings settings;
    settings.neighbours = 1000;
    EXPECT_EQ(neighbourhoods(randomPoints(20, 43), {{0.5, 0.5, 0.5}}, settings).front().size(), 20u);
}

TEST(Smoothing, TheOrderIsTheSameEveryTime) {
    const auto points = randomPoints(2000, 44);
    EXPECT_EQ(neighbourhoods(points, points, ball(0.2)), neighbourhoods(points, points, ball(0.2)));
}

TEST(Smoothing, TheKernelIsTheOneThatThePaperPrints) {
    SmoothingSettings settings;
    EXPECT_EQ(smoothingWeight(settings, 4.0), 1.0);
    settings.weights = SmoothingWeights::Gaussian;
    settings.sigma_m = 0.05;
    EXPECT_EQ(smoothingWeight(settings, 0.0), 1.0);
    EXPECT_NEAR(smoothingWeight(settings, 0.05 * 0.05), std::exp(-1.0), 1e-15);
    EXPECT_NEAR(smoothingWeight(settings, 0.2 * 0.2), std::exp(-16.0), 1e-20);
}

TEST(Smoothing, AllSettingsOutOfRangeAreToldAtOnce) {
    SmoothingSettings settings;
    settings.neighbours = 0;
    settings.radius_m = -1.0;
    settings.sigma_m = std::nan("");
    EXPECT_EQ(smoothingProblems(settings).size(), 3u);
    const std::vector<Eigen::Vector3d> points = randomPoints(5, 45);
    expectError([&] { neighbourhoods(points, points, settings); }, "at least 1, not 0");
    expectError([&] { neighbourhoods(points, points, settings); }, "radius");
    expectError([&] { neighbourhoods(points, points, settings); }, "sigma");
}

TEST(Smoothing, StopsWhenCancelled) {
    const auto points = randomPoints(500, 46);
    const NeighbourIndex index(points);
    Progress progress;
    progress.cancel();
    EXPECT_THROW(forEachNeighbourhood(
                     index, points, ball(0.1), "test", [](auto, auto) {}, progress),
                 Cancelled);
}

TEST(RandomSample, KeepsTheShareInOrderAndTheSameForTheSameSeed) {
    const auto sample = randomSample(1005, 0.1, 7);
    EXPECT_EQ(sample.size(), 100u);
    EXPECT_TRUE(std::is_sorted(sample.begin(), sample.end()));
    EXPECT_EQ(std::adjacent_find(sample.begin(), sample.end()), sample.end());
    EXPECT_LT(sample.back(), 1005u);
    EXPECT_EQ(randomSample(1005, 0.1, 7), sample);
    EXPECT_NE(randomSample(1005, 0.1, 8), sample);
}

TEST(RandomSample, EveryThingIsAsLikelyAsAnyOther) {
    std::vector<int> drawn(20, 0);
    for (std::uint64_t seed = 0; seed < 4000; ++seed)
        for (const std::uint32_t index : randomSample(20, 0.25, seed))
            ++drawn[index];
    // 1000 expected with a standard deviation of 27.
    for (const int count : drawn)
        EXPECT_NEAR(count, 1000, 140);
}

TEST(RandomSample, KeepsAllOrOneAtTheEndsAndRefusesOtherShares) {
    EXPECT_EQ(randomSample(5, 1.0, 1), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
    EXPECT_EQ(randomSample(5, 0.01, 1).size(), 1u);
    EXPECT_TRUE(randomSample(0, 0.5, 1).empty());
    for (const double ratio : {0.0, -0.1, 1.5, std::nan("")})
        expectError([&] { randomSample(5, ratio, 1); }, "random ratio");
}

}  // namespace
}  // namespace fodscope
