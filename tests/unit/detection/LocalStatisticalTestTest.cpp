// SPDX-License-Identifier: MIT
#include "core/detection/LocalStatisticalTest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <string>

#include "core/common/Error.h"
#include "core/detection/ChiSquareQuantile.h"
#include "tests/unit/cloud/RandomPoints.h"

namespace fodscope {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Row = std::map<std::string, std::string>;

/// A file of tests/data/chi_square, which make_fixture.py there made with CloudCompare and scipy.
std::vector<Row> readFixture(const std::string& name) {
    std::ifstream file(std::string(FODSCOPE_TEST_DATA) + "/chi_square/" + name);
    EXPECT_TRUE(file) << name;
    std::vector<std::string> header;
    std::vector<Row> rows;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        Row row;
        std::size_t column = 0;
        for (std::string word; std::getline(words, word, ','); ++column) {
            if (rows.empty() && header.size() == column && row.empty())
                header.push_back(word);
            else
                row[header.at(column)] = word;
        }
        if (!row.empty()) rows.push_back(row);
    }
    return rows;
}

std::vector<double> column(const std::vector<Row>& rows, const std::string& name) {
    std::vector<double> values;
    for (const Row& row : rows)
        values.push_back(std::stod(row.at(name)));
    return values;
}

struct Cloud {
    std::vector<Row> rows = readFixture("local_test.csv");
    std::vector<Eigen::Vector3d> points;

    Cloud() {
        const std::vector<double> x = column(rows, "x"), y = column(rows, "y"), z = column(rows, "z");
        for (std::size_t i = 0; i < rows.size(); ++i)
            points.emplace_back(x[i], y[i], z[i]);
    }
};

FittedDistribution distributionOf(const Row& row) {
    const double a = std::stod(row.at("a"));
    const double b = std::stod(row.at("b"));
    if (row.at("distribution") == "gauss") return GaussFit{a, b};
    return WeibullFit{a, b, std::stod(row.at("shift"))};
}

std::vector<double> test(std::span<const Eigen::Vector3d> points, std::span<const double> values,
                         const FittedDistribution& distribution, int neighbours) {
    Progress progress;
    return localChiSquare(points, values, distribution, neighbours, progress);
}

TEST(LocalStatisticalTest, AgreesWithCloudCompare) {
    const Cloud cloud;
    const std::vector<Row> tests = readFixture("tests.csv");
    ASSERT_EQ(cloud.points.size(), 700u);
    ASSERT_EQ(tests.size(), 20u);
    for (std::size_t i = 0; i < tests.size(); ++i) {
        const Row& row = tests[i];
        const std::vector<double> distances = test(cloud.points, column(cloud.rows, row.at("values")),
                                                   distributionOf(row), std::stoi(row.at("neighbours")));
        const std::vector<double> expected = column(cloud.rows, "test_" + std::to_string(i));
        for (std::size_t point = 0; point < expected.size(); ++point) {
            // CloudCompare keeps values and parameters in float, of which χ² takes differences.
            ASSERT_NEAR(distances[point], expected[point], 2e-5 * (1.0 + expected[point]))
                << "test " << i << " point " << point;
        }
    }
}

TEST(LocalStatisticalTest, ThresholdsAreTheRootsOfChiSquareQuantiles) {
    for (const Row& row : readFixture("tests.csv")) {
        LocalStatisticalTestSettings settings;
        settings.neighbours = std::stoi(row.at("neighbours"));
        settings.pValue = std::stod(row.at("p_value"));
        EXPECT_NEAR(testThreshold(settings), std::stod(row.at("exact_threshold")), 1e-9);
        EXPECT_NEAR(testThreshold(settings), std::stod(row.at("threshold")), 1e-5);
    }
}

TEST(LocalStatisticalTest, FitsTheDistributionsThatCloudCompareDefines) {
    const Cloud cloud;
    for (const Row& row : readFixture("fits.csv")) {
        const std::vector<double> values = column(cloud.rows, row.at("values"));
        const double a = std::stod(row.at("a"));
        const double b = std::stod(row.at("b"));
        if (row.at("distribution") == "gauss") {
            const GaussFit fit = fitGauss(values);
            // The fixture's values are float32 written with nine digits.
            EXPECT_NEAR(fit.mean, a, 1e-8 * a);
            EXPECT_NEAR(fit.standardDeviation, b, 1e-8 * b);
        } else {
            const WeibullFit fit = fitWeibull(values);
            EXPECT_NEAR(fit.shape, a, 1e-7 * a);
            EXPECT_NEAR(fit.scale, b, 1e-7 * b);
            EXPECT_NEAR(fit.shift, std::stod(row.at("shift")), 1e-10);
        }
    }
}

TEST(LocalStatisticalTest, CountsWhatLiesOutsideOfThreeSigmaAsAMillionth) {
    // Two neighbours, two classes of one half each (to 3 σ): one neighbour in the second class, one far above.
    const std::vector<Eigen::Vector3d> points{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};
    const std::vector<double> distances = test(points, std::vector<double>{0.5, 9.0}, GaussFit{0.0, 1.0}, 2);
    const double half = 2.0 * 0.5 * std::erf(3.0 / std::sqrt(2.0));
    const double expected = half + (1.0 - half) * (1.0 - half) / half + (1.0 - 2e-6) * (1.0 - 2e-6) / 2e-6;
    EXPECT_NEAR(distances[0], std::sqrt(expected), 1e-9 * std::sqrt(expected));
}

TEST(LocalStatisticalTest, ADistanceEndsAtTenMillion) {
    const std::vector<Eigen::Vector3d> points{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}};
    // All neighbours 0: no class of a Weibull distribution up to 0 has a probability.
    for (const double distance : test(points, std::vector<double>{0.0, 0.0, 0.0}, WeibullFit{1.5, 0.02, 0.0}, 3))
        EXPECT_DOUBLE_EQ(distance, std::sqrt(1e7));
}

TEST(LocalStatisticalTest, TakesTheWholeCloudWhereItHasFewerPointsThanNeighbours) {
    const auto points = randomPoints(20, 5);
    std::vector<double> values;
    for (const auto& point : points)
        values.push_back(0.02 + 0.01 * point.x());
    const GaussFit fit = fitGauss(values);
    const std::vector<double> all = test(points, values, fit, 20);
    EXPECT_EQ(test(points, values, fit, 1000000), all);
    for (const double distance : all)
        EXPECT_DOUBLE_EQ(distance, all.front());
}

TEST(LocalStatisticalTest, LeavesOutPointsWithoutAValue) {
    auto points = randomPoints(60, 6);
    std::vector<double> values;
    for (const auto& point : points)
        values.push_back(0.02 + 0.01 * point.x());
    Progress progress;
    const std::vector<double> without = localStatisticalTest(points, values, {}, progress);
    points.insert(points.begin(), {points[0], points[1], points[2]});
    values.insert(values.begin(), {kNan, kInfinity, -kInfinity});
    const std::vector<double> with = localStatisticalTest(points, values, {}, progress);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_TRUE(std::isnan(with[i]));
    EXPECT_EQ(std::vector<double>(with.begin() + 3, with.end()), without);
}

TEST(LocalStatisticalTest, CoincidentPointsAreNeighboursInTheirOrder) {
    const std::vector<Eigen::Vector3d> points(40, Eigen::Vector3d(1.0, 2.0, 3.0));
    std::vector<double> values;
    for (int i = 0; i < 40; ++i)
        values.push_back(0.01 + 0.001 * (i * 7 % 40));
    Progress progress;
    LocalStatisticalTestSettings settings;
    for (const TestDistribution distribution : {TestDistribution::Gauss, TestDistribution::Weibull}) {
        settings.distribution = distribution;
        const std::vector<double> distances = localStatisticalTest(points, values, settings, progress);
        for (const double distance : distances)
            EXPECT_DOUBLE_EQ(distance, distances.front());
    }
}

TEST(LocalStatisticalTest, RefusesWhatCannotBeTested) {
    const auto points = randomPoints(20, 7);
    const std::vector<double> equal(20, 0.01);
    std::vector<double> values = equal;
    values.back() = 0.02;
    Progress progress;
    LocalStatisticalTestSettings settings;
    EXPECT_THROW(localStatisticalTest(points, equal, settings, progress), Error);
    settings.distribution = TestDistribution::Weibull;
    EXPECT_THROW(localStatisticalTest(points, equal, settings, progress), Error);
    EXPECT_THROW(localStatisticalTest(points, std::vector<double>(20, kNan), settings, progress), Error);
    EXPECT_THROW(localStatisticalTest(points, std::vector<double>(19, 0.0), settings, progress), Error);
    EXPECT_THROW(localStatisticalTest({}, {}, settings, progress), Error);
    for (const int neighbours : {-1, 0, 1}) {
        settings.neighbours = neighbours;
        EXPECT_THROW(localStatisticalTest(points, values, settings, progress), Error);
        EXPECT_THROW(testThreshold(settings), Error);
    }
    settings.neighbours = 16;
    for (const double pValue : {-0.1, 0.0, 1.0, kNan}) {
        settings.pValue = pValue;
        EXPECT_THROW(testThreshold(settings), Error);
    }
    settings.neighbours = 1;
    settings.pValue = 2.0;
    try {
        localStatisticalTest(points, values, settings, progress);
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "chi-square settings: the neighbours must be at least 2, not 1, the p-value must be greater than "
                     "0 and less than 1; the defaults are 16 neighbours and a p-value of 0.0005");
    }
}

TEST(LocalStatisticalTest, CanBeCancelled) {
    const auto points = randomPoints(20, 8);
    std::vector<double> values(20, 0.01);
    values.back() = 0.02;
    Progress progress;
    progress.cancel();
    EXPECT_THROW(localStatisticalTest(points, values, {}, progress), Cancelled);
}

TEST(ChiSquareQuantile, AgreesWithScipy) {
    // scipy.stats.chi2.sf and .isf
    EXPECT_NEAR(chiSquareSurvival(3.8414588206941285, 1), 0.05, 1e-13);
    EXPECT_NEAR(chiSquareSurvival(20.0, 7), 0.005569683072945574, 1e-14);
    EXPECT_NEAR(chiSquareSurvival(400.0, 300), 9.678621994933555e-05, 1e-15);
    EXPECT_DOUBLE_EQ(chiSquareSurvival(0.0, 3), 1.0);
    EXPECT_NEAR(chiSquareQuantile(0.0005, 3), 17.729996228945925, 1e-11);
    EXPECT_NEAR(chiSquareQuantile(1e-12, 1), 50.844127911818155, 1e-10);
    EXPECT_NEAR(chiSquareQuantile(0.999, 200), 143.8427949900008, 1e-9);
    EXPECT_THROW(chiSquareQuantile(0.5, 0), Error);
}

}  // namespace
}  // namespace fodscope
