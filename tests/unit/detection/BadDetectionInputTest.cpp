// SPDX-License-Identifier: MIT
// Clouds, references and transforms that are broken: what is unknown stays unknown, the rest is an error that says so.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/detection/Candidates.h"
#include "core/detection/Discrepancy.h"
#include "tests/unit/cloud/ExpectError.h"
#include "tests/unit/cloud/RandomPoints.h"

namespace fodscope {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

ReferenceMap trainedReference() {
    ReferenceMap reference;
    reference.points = randomPoints(400, 91);
    reference.covariance.assign(reference.size(), 1e-4 * Eigen::Matrix3d::Identity());
    reference.untrained.assign(reference.size(), 0);
    return reference;
}

DiscrepancyField measure(const std::vector<Eigen::Vector3d>& map, const ReferenceMap& reference,
                         bool cropToReference = true, const Transform& T_reference_from_map = Transform::Identity()) {
    DiscrepancySettings settings;
    settings.cropToReference = cropToReference;
    Progress progress;
    return measureDiscrepancy(map, T_reference_from_map, reference, settings, progress);
}

TEST(BadDetectionInput, MapPointsThatAreNotFiniteAreLeftOut) {
    const auto good = randomPoints(200, 92);
    auto map = good;
    map.insert(map.begin() + 50, {{kNan, 0.5, 0.5}, {0.5, kInfinity, 0.5}, {0.5, 0.5, -kInfinity}});
    for (const bool crop : {true, false}) {
        const DiscrepancyField field = measure(map, trainedReference(), crop);
        EXPECT_EQ(field.points, measure(good, trainedReference(), crop).points);
        EXPECT_EQ(field.smoothedMahalanobis, measure(good, trainedReference(), crop).smoothedMahalanobis);
    }
    expectError([&] { measure({{kNan, kNan, kNan}}, trainedReference()); }, "no point of it lies within");
    expectError([&] { measure({}, trainedReference()); }, "no point of it lies within");
}

TEST(BadDetectionInput, ATransformThatIsNoneIsAnError) {
    Transform broken = Transform::Identity();
    broken.matrix()(0, 3) = kNan;
    expectError([&] { measure(randomPoints(50, 93), trainedReference(), true, broken); }, "the transform");
    expectError([&] { measure(randomPoints(50, 93), trainedReference(), false, broken); }, "the transform");
}

TEST(BadDetectionInput, ReferencesThatAreNotFiniteOrDoNotFitTogetherAreErrors) {
    const auto map = randomPoints(50, 94);
    ReferenceMap reference = trainedReference();
    reference.points[7].z() = kNan;
    expectError([&] { measure(map, reference, false); }, "a coordinate is not finite");
    reference = trainedReference();
    reference.covariance.pop_back();
    expectError([&] { measure(map, reference); }, "not one covariance a point");
    reference = trainedReference();
    reference.untrained.push_back(0);
    expectError([&] { measure(map, reference); }, "not one covariance a point");
    expectError([&] { measure(map, {}); }, "no points");
}

TEST(BadDetectionInput, CovariancesThatAreNoneGiveNoMahalanobisDiscrepancy) {
    const auto map = randomPoints(50, 95);
    const Eigen::Matrix3d indefinite = Eigen::Vector3d(1.0, -1.0, 1.0).asDiagonal();
    for (const Eigen::Matrix3d& broken :
         {Eigen::Matrix3d(Eigen::Matrix3d::Constant(kNan)), Eigen::Matrix3d(Eigen::Matrix3d::Constant(kInfinity)),
          Eigen::Matrix3d(kInfinity * Eigen::Matrix3d::Identity()), Eigen::Matrix3d(Eigen::Matrix3d::Zero()),
          indefinite}) {
        ReferenceMap reference = trainedReference();
        reference.covariance.assign(reference.size(), broken);
        const DiscrepancyField field = measure(map, reference);
        for (std::size_t i = 0; i < field.size(); ++i) {
            EXPECT_TRUE(std::isnan(field.mahalanobis[i])) << broken;
            EXPECT_TRUE(std::isnan(field.smoothedMahalanobis[i])) << broken;
            EXPECT_FALSE(std::isnan(field.smoothedEuclidean_m[i]));
        }
        Progress progress;
        const CandidateSet set = findCandidates(field, paperPhysicalCandidateSettings(Metric::Mahalanobis), 0.02, 0.0,
                                                Transform::Identity(), progress);
        EXPECT_EQ(set.pointsAboveThreshold, 0u);
        EXPECT_TRUE(set.candidates.empty());
    }
}

TEST(BadDetectionInput, CoincidentPointsAreOneVoxelWithAllTheirWeight) {
    const DiscrepancyField field =
        measure(std::vector<Eigen::Vector3d>(300, Eigen::Vector3d(0.5, 0.5, 0.5)), trainedReference());
    ASSERT_EQ(field.size(), 1u);
    EXPECT_EQ(field.weights[0], 300u);
    // Fewer voxels than neighbours to smooth over: the voxel alone.
    EXPECT_DOUBLE_EQ(field.smoothedEuclidean_m[0], field.euclidean_m[0]);
    Progress progress;
    expectError([&] { withChiSquare(field, {}, progress); }, "all values are equal");
}

TEST(BadDetectionInput, CoincidentReferencePointsGiveTheFirstOfThem) {
    ReferenceMap reference;
    reference.points.assign(20, Eigen::Vector3d(0.5, 0.5, 0.5));
    const DiscrepancyField field = measure(randomPoints(50, 96), reference, false);
    for (const std::uint32_t nearest : field.nearest)
        EXPECT_EQ(nearest, 0u);
    expectError([&] { measure(randomPoints(50, 96), reference); }, "no point of it lies within");
}

}  // namespace
}  // namespace fodscope
