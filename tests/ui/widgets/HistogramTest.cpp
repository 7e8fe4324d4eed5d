// SPDX-License-Identifier: MIT
#include "ui/widgets/Histogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace fodscope {
namespace {

TEST(Histogram, CountsAboveAsOneByOneDoes) {
    std::mt19937 random(7);
    std::lognormal_distribution<double> spread(0.0, 0.8);
    std::vector<double> values(5000);
    for (double& value : values)
        value = spread(random);
    const Histogram histogram(values, 64);
    for (const double threshold : {-1.0, 0.0, 0.3, values[17], 2.75, 50.0, 1e9}) {
        const auto above = std::count_if(values.begin(), values.end(), [&](double v) { return v > threshold; });
        EXPECT_EQ(histogram.countAbove(threshold), static_cast<std::size_t>(above)) << threshold;
    }
}

TEST(Histogram, TheThresholdItselfIsNotAbove) {
    const std::vector<double> values = {1.0, 2.75, 2.75, 3.0};
    EXPECT_EQ(Histogram(values, 8).countAbove(2.75), 1U);
}

TEST(Histogram, EveryKnownValueIsInOneBin) {
    std::vector<double> values(1000, 0.5);
    values.push_back(1e6);
    values.push_back(std::nan(""));
    values.push_back(INFINITY);
    const Histogram histogram(values, 32);
    const auto& counts = histogram.counts();
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::size_t{0}), 1001U);
    EXPECT_EQ(histogram.total(), 1001U);
    EXPECT_EQ(histogram.unknown(), 2U);
}

TEST(Histogram, OneFarValueDoesNotSqueezeTheRest) {
    std::vector<double> values;
    for (int i = 0; i < 10000; ++i)
        values.push_back(i / 10000.0);
    values.push_back(1e6);
    const Histogram histogram(values, 32);
    EXPECT_LT(histogram.maximum(), 2.0);
    EXPECT_EQ(histogram.largest(), 1e6);
    EXPECT_EQ(histogram.countAbove(1000.0), 1U);
}

TEST(Histogram, NothingAndOneValueAreFine) {
    EXPECT_TRUE(Histogram({}, 10).empty());
    EXPECT_EQ(Histogram({}, 10).countAbove(0.0), 0U);
    const std::vector<double> one = {0.0};
    const Histogram histogram(one, 10);
    EXPECT_GT(histogram.maximum(), histogram.minimum());
    EXPECT_EQ(histogram.countAbove(-1.0), 1U);
}

}  // namespace
}  // namespace fodscope
