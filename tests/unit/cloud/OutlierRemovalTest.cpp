// SPDX-License-Identifier: MIT
#include "core/cloud/OutlierRemoval.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/common/Error.h"
#include "tests/unit/cloud/RandomPoints.h"

namespace fodscope {
namespace {

std::vector<std::uint32_t> bruteForce(const std::vector<Eigen::Vector3d>& points, std::size_t k, double deviations) {
    std::vector<double> means;
    for (const Eigen::Vector3d& point : points) {
        std::vector<double> distances;
        for (const Eigen::Vector3d& other : points)
            distances.push_back((other - point).norm());
        std::sort(distances.begin(), distances.end());
        double sum = 0.0;
        for (std::size_t i = 0; i < k; ++i)
            sum += distances[i];
        means.push_back(sum / static_cast<double>(k));
    }
    double mean = 0.0;
    for (const double value : means)
        mean += value / static_cast<double>(means.size());
    double variance = 0.0;
    for (const double value : means)
        variance += (value - mean) * (value - mean) / static_cast<double>(means.size() - 1);
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < means.size(); ++i)
        if (means[i] < mean + deviations * std::sqrt(variance)) kept.push_back(static_cast<std::uint32_t>(i));
    return kept;
}

TEST(OutlierRemoval, AgreesWithTheDefinition) {
    const auto points = randomPoints(400, 11);
    Progress progress;
    const auto kept = keptByOutlierRemoval(points, {true, 20, 1.0}, progress);
    EXPECT_EQ(kept, bruteForce(points, 20, 1.0));
    EXPECT_LT(kept.size(), points.size());
}

TEST(OutlierRemoval, DropsAPointFarFromAllOthers) {
    auto points = randomPoints(300, 12);
    points[17] = {9.0, 9.0, 9.0};
    Progress progress;
    const auto kept = keptByOutlierRemoval(points, {}, progress);
    EXPECT_FALSE(std::binary_search(kept.begin(), kept.end(), 17u));
    EXPECT_EQ(kept.size(), 299u);
}

TEST(OutlierRemoval, KeepsAllWhenSwitchedOffOrWithoutSpread) {
    Progress progress;
    const auto points = randomPoints(100, 13);
    EXPECT_EQ(keptByOutlierRemoval(points, {false, 5, 0.1}, progress).size(), 100u);
    const std::vector<Eigen::Vector3d> coincident(30, Eigen::Vector3d::Ones());
    EXPECT_EQ(keptByOutlierRemoval(coincident, {}, progress).size(), 30u);
    EXPECT_EQ(keptByOutlierRemoval(std::vector<Eigen::Vector3d>{{1, 2, 3}}, {}, progress).size(), 1u);
    EXPECT_TRUE(keptByOutlierRemoval({}, {}, progress).empty());
}

TEST(OutlierRemoval, RefusesSettingsOutOfRange) {
    const auto points = randomPoints(10, 14);
    Progress progress;
    EXPECT_THROW(keptByOutlierRemoval(points, {true, 0, 2.0}, progress), Error);
    EXPECT_THROW(keptByOutlierRemoval(points, {true, 50, 0.0}, progress), Error);
    EXPECT_THROW(keptByOutlierRemoval(points, {true, 50, std::nan("")}, progress), Error);
}

TEST(OutlierRemoval, TakesTheWholeCloudWhereItHasFewerPointsThanNeighbours) {
    const auto points = randomPoints(30, 15);
    Progress progress;
    EXPECT_EQ(keptByOutlierRemoval(points, {true, 1000000, 1.0}, progress),
              keptByOutlierRemoval(points, {true, 30, 1.0}, progress));
}

TEST(OutlierRemoval, RefusesPointsThatAreNotFinite) {
    Progress progress;
    for (const double bad : {std::nan(""), HUGE_VAL}) {
        auto points = randomPoints(10, 16);
        points[3].x() = bad;
        EXPECT_THROW(keptByOutlierRemoval(points, {}, progress), Error);
    }
}

TEST(Select, TakesPointsWithTheirColours) {
    PointCloud cloud;
    cloud.points = randomPoints(3, 15);
    cloud.colours = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
    const PointCloud selected = select(cloud, std::vector<std::uint32_t>{2, 0});
    EXPECT_EQ(selected.points, (std::vector<Eigen::Vector3d>{cloud.points[2], cloud.points[0]}));
    EXPECT_EQ(selected.colours, (std::vector<Rgb>{{7, 8, 9}, {1, 2, 3}}));
}

TEST(KeepOnly, LeavesPointsWithTheirColours) {
    PointCloud cloud;
    cloud.points = randomPoints(4, 15);
    cloud.colours = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {0, 0, 0}};
    const PointCloud selected = select(cloud, std::vector<std::uint32_t>{0, 2, 3});
    keepOnly(cloud, std::vector<std::uint32_t>{0, 2, 3});
    EXPECT_EQ(cloud.points, selected.points);
    EXPECT_EQ(cloud.colours, selected.colours);
}

}  // namespace
}  // namespace fodscope
