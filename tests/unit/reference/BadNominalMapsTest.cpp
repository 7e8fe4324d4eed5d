// SPDX-License-Identifier: MIT
// Nominal maps that are no maps: an error that says so, or points that are marked as untrained, never a guess.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/reference/MeanReference.h"
#include "tests/unit/cloud/ExpectError.h"
#include "tests/unit/cloud/RandomPoints.h"

namespace fodscope {
namespace {

ReferenceMap referenceOf(const std::vector<Eigen::Vector3d>& points, bool denoise,
                         const Transform& T_reference_from_map = Transform::Identity()) {
    PointCloud map;
    map.points = points;
    MeanReferenceSettings settings;
    settings.denoise.enabled = denoise;
    Progress progress;
    return meanReference(std::vector<AlignedNominalMap>{{&map, T_reference_from_map}}, settings, progress);
}

void expectAllUntrained(const ReferenceMap& reference) {
    ASSERT_EQ(reference.untrained.size(), reference.size());
    for (std::size_t i = 0; i < reference.size(); ++i) {
        EXPECT_EQ(reference.untrained[i], 1);
        EXPECT_TRUE(reference.covariance[i].array().isNaN().all());
    }
}

TEST(BadNominalMaps, CoordinatesThatAreNotFiniteAreAnError) {
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        auto points = randomPoints(100, 81);
        points[50].y() = bad;
        for (const bool denoise : {true, false})
            expectError([&] { referenceOf(points, denoise); }, "not finite");
    }
}

TEST(BadNominalMaps, ATransformThatIsNoneIsAnError) {
    Transform broken = Transform::Identity();
    broken.translation().x() = std::nan("");
    expectError([&] { referenceOf(randomPoints(100, 82), true, broken); }, "not finite");
}

TEST(BadNominalMaps, CoincidentPointsGiveOneUntrainedPoint) {
    for (const bool denoise : {true, false}) {
        const ReferenceMap reference =
            referenceOf(std::vector<Eigen::Vector3d>(500, Eigen::Vector3d(1.0, 2.0, 3.0)), denoise);
        ASSERT_EQ(reference.size(), 1u);
        EXPECT_EQ(reference.points[0], Eigen::Vector3d(1.0, 2.0, 3.0));
        EXPECT_EQ(reference.occupancy[0], 500);
        EXPECT_EQ(reference.sampleCount[0], 500);
        expectAllUntrained(reference);
    }
}

TEST(BadNominalMaps, PointsInOnePlaneOrOnOneLineSupportNoCovariance) {
    auto points = randomPoints(800, 83);
    for (Eigen::Vector3d& point : points)
        point.z() = 0.25;
    expectAllUntrained(referenceOf(points, false));
    for (Eigen::Vector3d& point : points)
        point.y() = 0.5;
    expectAllUntrained(referenceOf(points, false));
}

TEST(BadNominalMaps, ASinglePointAndMoreNeighboursThanPointsAreTaken) {
    expectAllUntrained(referenceOf({{1.0, 2.0, 3.0}}, true));
    auto points = randomPoints(400, 84);
    for (Eigen::Vector3d& point : points)
        point *= 0.2;
    const ReferenceMap few = referenceOf(points, false);
    ASSERT_GT(few.size(), 10u);
    ASSERT_LT(few.size(), 250u);
    EXPECT_EQ(std::count(few.untrained.begin(), few.untrained.end(), 0), static_cast<std::ptrdiff_t>(few.size()));
}

TEST(BadNominalMaps, AMapThatSpansTheWorldIsAnErrorAndNotALackOfMemory) {
    expectError([&] { referenceOf({{0.0, 0.0, 0.0}, {1e9, 0.0, 0.0}}, false); }, "voxels");
    expectError([&] { referenceOf({{0.0, 0.0, 0.0}, {1e300, -1e300, 0.0}}, false); }, "voxels");
}

}  // namespace
}  // namespace fodscope
