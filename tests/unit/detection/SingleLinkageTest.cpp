// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "core/common/Error.h"
#include "core/detection/HierarchicalClustering.h"
#include "tests/unit/cloud/RandomPoints.h"
#include "tests/unit/detection/BruteForceClusters.h"

namespace fodscope {
namespace {

Labels cluster(const std::vector<Eigen::Vector3d>& points, double cutoff_m) {
    Progress progress;
    return linkageClusters(points, Linkage::Single, cutoff_m, progress);
}

/// Connected components of the pairs within the cutoff.
Labels components(const std::vector<Eigen::Vector3d>& points, double cutoff_m) {
    Labels labels(points.size());
    std::iota(labels.begin(), labels.end(), 0u);
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < points.size(); ++i) {
            for (std::size_t j = 0; j < points.size(); ++j) {
                if (labels[j] >= labels[i] || !((points[i] - points[j]).norm() <= cutoff_m)) continue;
                labels[i] = labels[j];
                changed = true;
            }
        }
    }
    std::vector<std::uint32_t> numbers(points.size());
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (labels[i] == i) numbers[i] = next++;
        labels[i] = numbers[labels[i]];
    }
    return labels;
}

TEST(SingleLinkage, GivesTheConnectedComponents) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const auto points = randomPoints(400, seed);
        for (const double cutoff : {0.0, 0.02, 0.05, 0.08, 0.1, 0.12, 0.2, 2.0})
            ASSERT_EQ(cluster(points, cutoff), components(points, cutoff)) << "seed " << seed << " cutoff " << cutoff;
    }
}

TEST(SingleLinkage, MergesInTheOrderOfDistance) {
    Progress progress;
    const auto points = randomPoints(500, 4);
    const MergeSequence sequence = mergeSequence(points, Linkage::Single, 2.0, progress);
    ASSERT_EQ(sequence.merges.size(), 499u);
    for (std::size_t i = 0; i < sequence.merges.size(); ++i) {
        EXPECT_LT(sequence.merges[i].kept, sequence.merges[i].removed);
        if (i > 0) {
            EXPECT_GE(sequence.merges[i].distance_m, sequence.merges[i - 1].distance_m);
        }
    }
}

TEST(SingleLinkage, FollowsAChainThatCentroidLinkageBreaks) {
    std::vector<Eigen::Vector3d> chain;
    for (int i = 0; i < 50; ++i)
        chain.emplace_back(0.1 * i, 0.0, 0.0);
    EXPECT_EQ(cluster(chain, 0.11), Labels(50, 0));
    Progress progress;
    EXPECT_GT(linkageClusters(chain, Linkage::Centroid, 0.11, progress).back(), 0u);
}

TEST(SingleLinkage, MergesAtExactlyTheCutoff) {
    const std::vector<Eigen::Vector3d> row{{3.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {4.5, 0.0, 0.0}};
    EXPECT_EQ(cluster(row, 1.0), (Labels{0, 1, 0, 2}));
    EXPECT_EQ(cluster(row, 0.999), (Labels{0, 1, 2, 3}));
    EXPECT_EQ(cluster(row, 1.5), (Labels{0, 1, 0, 0}));
    EXPECT_EQ(cluster(row, 2.0), (Labels{0, 0, 0, 0}));
}

TEST(SingleLinkage, CutoffZeroJoinsOnlyPointsAtTheSamePlace) {
    EXPECT_EQ(cluster({{0.1, 0.2, 0.3}, {0.4, 0.0, 0.0}, {0.1, 0.2, 0.3}, {0.4, 0.0, 1e-12}}, 0.0),
              (Labels{0, 1, 0, 2}));
    EXPECT_EQ(cluster(std::vector<Eigen::Vector3d>(20000, {1.0, 2.0, 3.0}), 0.0), Labels(20000, 0));
}

TEST(SingleLinkage, HoldsALargeSurfaceTogether) {
    auto points = randomPoints(30000, 9);
    for (Eigen::Vector3d& point : points)
        point = {6.0 * point.x(), 5.0 * point.y(), 0.02 * point.z()};
    points.emplace_back(20.0, 0.0, 0.0);
    const Labels labels = cluster(points, 0.2);
    EXPECT_EQ(labels.back(), 1u);
    EXPECT_EQ(std::count(labels.begin(), labels.end(), 0u), 30000);
}

TEST(SingleLinkage, RefusesACutoffThatIsNoLength) {
    EXPECT_THROW(cluster(randomPoints(3, 1), -0.1), Error);
    EXPECT_THROW(cluster(randomPoints(3, 1), std::nan("")), Error);
    EXPECT_THROW(cluster(randomPoints(3, 1), std::numeric_limits<double>::infinity()), Error);
    EXPECT_TRUE(cluster({}, 0.3).empty());
    EXPECT_EQ(cluster({{1.0, 2.0, 3.0}}, 0.3), (Labels{0}));
}

TEST(SingleLinkage, StopsWhenCancelled) {
    Progress progress;
    progress.cancel();
    EXPECT_THROW(linkageClusters(randomPoints(10, 1), Linkage::Single, 0.3, progress), Cancelled);
}

TEST(Linkage, RefusesPointsThatAreNotFinite) {
    Progress progress;
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        auto points = randomPoints(5, 1);
        points[3].y() = bad;
        for (const Linkage linkage : {Linkage::Centroid, Linkage::Single}) {
            try {
                linkageClusters(points, linkage, 0.3, progress);
                FAIL();
            } catch (const Error& error) {
                EXPECT_NE(std::string(error.what()).find("number 3"), std::string::npos) << error.what();
            }
        }
    }
}

TEST(Linkage, ASequenceIsNotCutBeyondItsLargestCutoff) {
    Progress progress;
    const MergeSequence sequence = mergeSequence(randomPoints(20, 1), Linkage::Centroid, 0.3, progress);
    EXPECT_NO_THROW(clustersAt(sequence, 0.3));
    EXPECT_THROW(clustersAt(sequence, 0.31), Error);
    EXPECT_THROW(clustersAt(sequence, -1.0), Error);
    EXPECT_THROW(clustersAt(sequence, std::nan("")), Error);
}

}  // namespace
}  // namespace fodscope
