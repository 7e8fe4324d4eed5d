// SPDX-License-Identifier: MIT
#include "core/detection/HierarchicalClustering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/common/Error.h"
#include "tests/unit/cloud/RandomPoints.h"
#include "tests/unit/detection/BruteForceClusters.h"

namespace fodscope {
namespace {

Labels cluster(const std::vector<Eigen::Vector3d>& points, double cutoff_m) {
    Progress progress;
    return linkageClusters(points, Linkage::Centroid, cutoff_m, progress);
}

Labels bruteForce(const std::vector<Eigen::Vector3d>& points, double cutoff_m) {
    return BruteForceClusters(points, Linkage::Centroid).at(cutoff_m);
}

TEST(CentroidLinkage, AgreesWithBruteForce) {
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
        const auto points = randomPoints(120, seed);
        for (const double cutoff : {0.0, 0.05, 0.1, 0.2, 0.3, 0.5, 2.0})
            ASSERT_EQ(cluster(points, cutoff), bruteForce(points, cutoff)) << "seed " << seed << " cutoff " << cutoff;
    }
}

TEST(CentroidLinkage, DoesNotJoinThroughAnInversion) {
    // The first merge is at 1, the second at √3/2: within a cutoff of 0.9 taken alone, but above a merge that is not.
    const std::vector<Eigen::Vector3d> triangle{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.5, std::sqrt(0.75) + 1e-9, 0.0}};
    EXPECT_EQ(cluster(triangle, 0.9), (Labels{0, 1, 2}));
    EXPECT_EQ(cluster(triangle, 1.0), (Labels{0, 0, 0}));
}

TEST(CentroidLinkage, MergesAtExactlyTheCutoffAndGivesTiesToTheLowerFirstPoint) {
    const std::vector<Eigen::Vector3d> row{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {3.0, 0.0, 0.0}};
    EXPECT_EQ(cluster(row, 1.0), (Labels{0, 0, 1, 1}));
    EXPECT_EQ(cluster(row, 0.999), (Labels{0, 1, 2, 3}));
    EXPECT_EQ(cluster(row, 2.0), (Labels{0, 0, 0, 0}));
    const std::vector<Eigen::Vector3d> shuffled{row[1], row[3], row[2], row[0]};
    // (1, 2) is tied with (1, 0) and (3, 2), and has the lowest first points.
    EXPECT_EQ(cluster(shuffled, 1.0), (Labels{0, 1, 0, 2}));
}

TEST(CentroidLinkage, NumbersClustersByTheirFirstPoint) {
    const std::vector<Eigen::Vector3d> points{
        {5.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {9.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, {5.1, 0.0, 0.0}};
    EXPECT_EQ(cluster(points, 0.2), (Labels{0, 1, 2, 1, 0}));
}

TEST(CentroidLinkage, CutoffZeroJoinsOnlyPointsAtTheSamePlace) {
    const std::vector<Eigen::Vector3d> points{
        {0.1, 0.2, 0.3}, {0.4, 0.0, 0.0}, {0.1, 0.2, 0.3}, {0.1, 0.2, 0.3}, {0.4, 0.0, 1e-12}};
    EXPECT_EQ(cluster(points, 0.0), (Labels{0, 1, 0, 0, 2}));
}

TEST(CentroidLinkage, WeighsPointsAtTheSamePlace) {
    // Nine points at 0 and one at 1 have their centroid at 0.1: the point at 1.3 is 1.2 away, not 0.8.
    std::vector<Eigen::Vector3d> points(9, Eigen::Vector3d::Zero());
    points.emplace_back(1.0, 0.0, 0.0);
    points.emplace_back(0.0, 1.3, 0.0);
    EXPECT_EQ(cluster(points, 1.1).back(), 1u);
    EXPECT_EQ(cluster(points, 1.31).back(), 0u);
    EXPECT_EQ(cluster(points, 1.1), bruteForce(points, 1.1));
}

TEST(CentroidLinkage, HandlesManyPointsAtOnePlace) {
    const std::vector<Eigen::Vector3d> points(50000, Eigen::Vector3d(0.1, 0.2, 0.3));
    EXPECT_EQ(cluster(points, 0.345), Labels(points.size(), 0));
}

TEST(CentroidLinkage, LeavesNoCentroidsWithinTheCutoffOnALargeSurface) {
    constexpr double cutoff = 0.345;
    auto points = randomPoints(20000, 9);
    for (Eigen::Vector3d& point : points)
        point = {6.0 * point.x(), 5.0 * point.y(), 0.02 * point.z()};
    const Labels labels = cluster(points, cutoff);
    std::map<std::uint32_t, std::pair<Eigen::Vector3d, int>> clusters;
    for (std::size_t i = 0; i < points.size(); ++i) {
        auto& [sum, count] = clusters.try_emplace(labels[i], Eigen::Vector3d::Zero(), 0).first->second;
        sum += points[i];
        ++count;
    }
    EXPECT_GT(clusters.size(), 50u);
    EXPECT_LT(clusters.size(), 500u);
    for (const auto& [label, a] : clusters) {
        for (const auto& [other, b] : clusters) {
            if (label >= other) continue;
            EXPECT_GT((a.first / a.second - b.first / b.second).norm(), cutoff);
        }
    }
}

TEST(CentroidLinkage, RefusesACutoffThatIsNoLength) {
    EXPECT_THROW(cluster(randomPoints(3, 1), -0.1), Error);
    EXPECT_THROW(cluster(randomPoints(3, 1), std::nan("")), Error);
    EXPECT_THROW(cluster(randomPoints(3, 1), std::numeric_limits<double>::infinity()), Error);
    EXPECT_TRUE(cluster({}, 0.3).empty());
    EXPECT_EQ(cluster({{1.0, 2.0, 3.0}}, 0.3), (Labels{0}));
}

TEST(CentroidLinkage, StopsWhenCancelled) {
    Progress progress;
    progress.cancel();
    EXPECT_THROW(linkageClusters(randomPoints(10, 1), Linkage::Centroid, 0.3, progress), Cancelled);
}

}  // namespace
}  // namespace fodscope
