// SPDX-License-Identifier: MIT
#include "core/detection/Candidates.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core/common/Error.h"

namespace fodscope {
namespace {

/// A 3 × 2 block of voxels about x = 1, a stronger single voxel at x = 3, and clear voxels between.
DiscrepancyField exampleField() {
    DiscrepancyField field;
    const auto add = [&](double x, double y, double z, double discrepancy) {
        field.points.emplace_back(x, y, z);
        field.smoothedEuclidean_m.push_back(discrepancy);
    };
    add(3.0, 1.0, 0.4, 0.09);
    add(2.0, 1.0, 0.0, 0.001);
    for (const double x : {0.95, 1.0, 1.05})
        for (const double y : {0.5, 0.55})
            add(x, y, 0.2, x > 1.01 ? 0.08 : 0.04);
    add(2.1, 1.0, 0.0, 0.03);
    add(2.2, 1.0, 0.0, std::nan(""));
    field.weights.assign(field.size(), 1);
    field.nearest.assign(field.size(), 0);
    field.euclidean_m = field.smoothedEuclidean_m;
    return field;
}

CandidateSettings euclidean() {
    CandidateSettings settings = paperPhysicalCandidateSettings(Metric::Euclidean);
    settings.minimumPoints = 0;
    return settings;
}

TEST(Candidates, AreMeasuredAndOrderedBySuspicion) {
    Progress progress;
    Transform T_reference_from_map = Transform::Identity();
    T_reference_from_map.translation() = Eigen::Vector3d(1.0, 0.0, 0.1);
    const CandidateSet set = findCandidates(exampleField(), euclidean(), 0.02, 0.05, T_reference_from_map, progress);
    // The threshold is exceeded strictly: 0.03 is not above it, and NaN never is.
    EXPECT_EQ(set.pointsAboveThreshold, 7u);
    ASSERT_EQ(set.candidates.size(), 2u);
    const Candidate& block = set.candidates[0];
    EXPECT_EQ(block.id, "C-001");
    EXPECT_EQ(block.voxels, (std::vector<std::uint32_t>{2, 3, 4, 5, 6, 7}));
    EXPECT_TRUE(block.centroid_reference.isApprox(Eigen::Vector3d(1.0, 0.525, 0.2)));
    EXPECT_TRUE(block.centroid_map.isApprox(Eigen::Vector3d(0.0, 0.525, 0.1)));
    EXPECT_TRUE(block.size_m.isApprox(Eigen::Vector3d(0.12, 0.07, 0.02)));
    EXPECT_NEAR(block.lengthDirection_rad, 0.0, 1e-12);
    EXPECT_NEAR(block.heightAboveFloor_m, 0.15, 1e-12);
    EXPECT_DOUBLE_EQ(block.discrepancyMax, 0.08);
    EXPECT_NEAR(block.discrepancySum, 0.32, 1e-12);
    EXPECT_NEAR(block.discrepancyMean, 0.32 / 6.0, 1e-12);
    const Candidate& single = set.candidates[1];
    EXPECT_EQ(single.id, "C-002");
    EXPECT_TRUE(single.size_m.isApprox(Eigen::Vector3d::Constant(0.02)));
    EXPECT_EQ(set.candidateOfVoxel, (std::vector<std::int32_t>{1, -1, 0, 0, 0, 0, 0, 0, -1, -1}));
}

TEST(Candidates, CanWeighTheCentroidByDiscrepancy) {
    Progress progress;
    CandidateSettings settings = euclidean();
    settings.centroid = CentroidKind::DiscrepancyWeighted;
    const CandidateSet set = findCandidates(exampleField(), settings, 0.02, 0.0, Transform::Identity(), progress);
    const double expected = (2 * 0.04 * 0.95 + 2 * 0.04 * 1.0 + 2 * 0.08 * 1.05) / 0.32;
    EXPECT_NEAR(set.candidates[0].centroid_reference.x(), expected, 1e-12);
}

TEST(Candidates, CanBeJoinedBySingleLinkage) {
    DiscrepancyField field;
    for (int i = 0; i < 10; ++i) {
        field.points.emplace_back(0.1 * i, 0.0, 0.0);
        field.smoothedEuclidean_m.push_back(0.5);
    }
    Progress progress;
    CandidateSettings settings = euclidean();
    settings.clusterCutoff_m = 0.11;
    const auto find = [&] { return findCandidates(field, settings, 0.02, 0.0, Transform::Identity(), progress); };
    EXPECT_GT(find().candidates.size(), 3u);
    settings.linkage = Linkage::Single;
    EXPECT_EQ(find().candidates.size(), 1u);
}

TEST(Candidates, WithFewerVoxelsThanTheLeastAreDropped) {
    Progress progress;
    CandidateSettings settings = euclidean();
    settings.minimumPoints = 2;
    const CandidateSet set = findCandidates(exampleField(), settings, 0.02, 0.0, Transform::Identity(), progress);
    ASSERT_EQ(set.candidates.size(), 1u);
    EXPECT_EQ(set.candidateOfVoxel[0], -1);
    EXPECT_EQ(set.pointsAboveThreshold, 7u);
    settings.minimumPoints = 7;
    EXPECT_TRUE(
        findCandidates(exampleField(), settings, 0.02, 0.0, Transform::Identity(), progress).candidates.empty());
}

TEST(Candidates, OfEqualSuspicionFollowTheirFirstVoxels) {
    DiscrepancyField field;
    field.points = {{2.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {3.0, 0.0, 0.0}};
    field.smoothedEuclidean_m = {0.5, 0.5, 0.5};
    Progress progress;
    const CandidateSet set = findCandidates(field, euclidean(), 0.02, 0.0, Transform::Identity(), progress);
    ASSERT_EQ(set.candidates.size(), 3u);
    for (std::uint32_t i = 0; i < 3; ++i)
        EXPECT_EQ(set.candidates[i].voxels, std::vector<std::uint32_t>{i});
}

TEST(Candidates, RefuseSettingsOutOfRangeAndMissingCovariances) {
    Progress progress;
    const auto find = [&](const CandidateSettings& settings, double voxel) {
        return findCandidates(exampleField(), settings, voxel, 0.0, Transform::Identity(), progress);
    };
    CandidateSettings settings = euclidean();
    settings.threshold = -0.1;
    EXPECT_THROW(find(settings, 0.02), Error);
    settings.threshold = std::nan("");
    EXPECT_THROW(find(settings, 0.02), Error);
    settings = euclidean();
    settings.clusterCutoff_m = -1.0;
    EXPECT_THROW(find(settings, 0.02), Error);
    settings = euclidean();
    settings.minimumPoints = -1;
    EXPECT_THROW(find(settings, 0.02), Error);
    EXPECT_THROW(find(euclidean(), 0.0), Error);
    EXPECT_THROW(find(paperPhysicalCandidateSettings(Metric::Mahalanobis), 0.02), Error);
}

TEST(PaperSettings, AreThoseOfThePhysicalTrials) {
    const CandidateSettings mahalanobis = paperPhysicalCandidateSettings(Metric::Mahalanobis);
    EXPECT_EQ(mahalanobis.threshold, 2.75);
    EXPECT_EQ(mahalanobis.clusterCutoff_m, 0.345);
    EXPECT_EQ(mahalanobis.minimumPoints, 0);
    const CandidateSettings euclidean = paperPhysicalCandidateSettings(Metric::Euclidean);
    EXPECT_EQ(euclidean.metric, Metric::Euclidean);
    EXPECT_EQ(euclidean.threshold, 0.030);
    EXPECT_EQ(euclidean.clusterCutoff_m, 0.279);
    EXPECT_EQ(euclidean.minimumPoints, 4);
}

}  // namespace
}  // namespace fodscope
