// SPDX-License-Identifier: MIT
#include "core/detection/HierarchicalClustering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "core/common/Error.h"
#include "tests/unit/cloud/RandomPoints.h"

namespace fodscope {
namespace {

using Labels = std::vector<std::uint32_t>;

Labels cluster(const std::vector<Eigen::Vector3d>& points, double cutoff_m) {
    Progress progress;
    return centroidLinkageClusters(points, cutoff_m, progress);
}

/// The definition, step by step: of all pairs merge the closest one, with the centroid as the mean of all members.
Labels bruteForce(const std::vector<Eigen::Vector3d>& points, double cutoff_m) {
    std::vector<std::vector<std::uint32_t>> clusters;
    for (std::uint32_t i = 0; i < points.size(); ++i)
        clusters.push_back({i});
    const auto centroid = [&](const std::vector<std::uint32_t>& members) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const std::uint32_t member : members)
            sum += points[member];
        return Eigen::Vector3d(sum / static_cast<double>(members.size()));
    };
    while (true) {
        std::vector<Eigen::Vector3d> centroids;
        for (const auto& members : clusters)
            centroids.push_back(centroid(members));
        double least = std::numeric_limits<double>::infinity();
        std::size_t first = 0;
        std::size_t second = 0;
        for (std::size_t i = 0; i < clusters.size(); ++i) {
            for (std::size_t j = i + 1; j < clusters.size(); ++j) {
                const double distance = (centroids[i] - centroids[j]).norm();
                if (distance >= least) continue;
                least = distance;
                first = i;
                second = j;
            }
        }
        if (!(least <= cutoff_m)) break;
        clusters[first].insert(clusters[first].end(), clusters[second].begin(), clusters[second].end());
        clusters.erase(clusters.begin() + static_cast<std::ptrdiff_t>(second));
    }
    Labels labels(points.size());
    for (std::uint32_t label = 0; label < clusters.size(); ++label)
        for (const std::uint32_t member : clusters[label])
            labels[member] = label;
    return labels;
}

TEST(CentroidLinkage, AgreesWithBruteForce) {
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
        const auto points = randomPoints(120, seed);
        for (const double cutoff : {0.0, 0.05, 0.1, 0.2, 0.3, 0.5, 2.0})
            ASSERT_EQ(cluster(points, cutoff), bruteForce(points, cutoff)) << "seed " << seed << " cutoff " << cutoff;
    }
}

TEST(CentroidLinkage, AgreesWithScipy) {
    std::ifstream file(std::string(FODSCOPE_TEST_DATA) + "/clustering/centroid_linkage.csv");
    ASSERT_TRUE(file);
    std::vector<double> cutoffs;
    std::vector<Eigen::Vector3d> points;
    std::vector<Labels> expected;
    std::string line;
    std::getline(file, line);
    std::istringstream header(line);
    for (std::string word; std::getline(header, word, ',');)
        if (word != "x" && word != "y" && word != "z") cutoffs.push_back(std::stod(word));
    expected.resize(cutoffs.size());
    while (std::getline(file, line)) {
        std::istringstream row(line);
        std::vector<double> values;
        for (std::string word; std::getline(row, word, ',');)
            values.push_back(std::stod(word));
        points.emplace_back(values[0], values[1], values[2]);
        for (std::size_t i = 0; i < cutoffs.size(); ++i)
            expected[i].push_back(static_cast<std::uint32_t>(values[3 + i]));
    }
    ASSERT_EQ(points.size(), 420u);
    for (std::size_t i = 0; i < cutoffs.size(); ++i)
        EXPECT_EQ(cluster(points, cutoffs[i]), expected[i]) << "cutoff " << cutoffs[i];
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
    EXPECT_THROW(centroidLinkageClusters(randomPoints(10, 1), 0.3, progress), Cancelled);
}

}  // namespace
}  // namespace fodscope
