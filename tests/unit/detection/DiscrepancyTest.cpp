// SPDX-License-Identifier: MIT
#include "core/detection/Discrepancy.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/cloud/VoxelGrid.h"
#include "core/common/Error.h"
#include "tests/unit/cloud/RandomPoints.h"

namespace fodscope {
namespace {

const Eigen::Matrix3d kCovariance =
    (Eigen::Matrix3d() << 4e-4, 1e-4, 0.0, 1e-4, 9e-4, -1e-4, 0.0, -1e-4, 1e-4).finished();

/// A unit cube of random points, with one covariance everywhere.
ReferenceMap trainedCube() {
    ReferenceMap reference;
    reference.points = randomPoints(500, 31);
    reference.covariance.assign(reference.size(), kCovariance);
    reference.untrained.assign(reference.size(), 0);
    return reference;
}

DiscrepancySettings settingsOf(double voxel, int smoothing) {
    DiscrepancySettings settings;
    settings.voxelSize_m = voxel;
    settings.smoothing.neighbours = smoothing;
    return settings;
}

std::uint32_t nearestByBruteForce(const ReferenceMap& reference, const Eigen::Vector3d& point) {
    const auto nearer = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
        return (a - point).squaredNorm() < (b - point).squaredNorm();
    };
    const auto found = std::min_element(reference.points.begin(), reference.points.end(), nearer);
    return static_cast<std::uint32_t>(found - reference.points.begin());
}

TEST(Discrepancy, FollowsTheDefinition) {
    const ReferenceMap reference = trainedCube();
    const auto map = randomPoints(3000, 32);
    Progress progress;
    const DiscrepancyField field =
        measureDiscrepancy(map, Transform::Identity(), reference, settingsOf(0.1, 7), progress);
    ASSERT_EQ(field.weights.size(), field.size());
    ASSERT_EQ(field.mahalanobis.size(), field.size());
    for (std::size_t i = 0; i < field.size(); i += 5) {
        EXPECT_EQ(field.nearest[i], nearestByBruteForce(reference, field.points[i]));
        const Eigen::Vector3d deviation = field.points[i] - reference.points[field.nearest[i]];
        EXPECT_NEAR(field.euclidean_m[i], deviation.norm(), 1e-12);
        const double squared = deviation.dot(kCovariance.inverse() * deviation);
        EXPECT_NEAR(field.mahalanobis[i], std::sqrt(squared), 1e-9 * std::sqrt(squared));

        std::vector<std::size_t> order(field.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return (field.points[a] - field.points[i]).squaredNorm() <
                   (field.points[b] - field.points[i]).squaredNorm();
        });
        double sum = 0.0;
        double squares = 0.0;
        double weight = 0.0;
        for (std::size_t j = 0; j < 7; ++j) {
            sum += field.weights[order[j]] * field.euclidean_m[order[j]];
            squares += field.weights[order[j]] * field.mahalanobis[order[j]];
            weight += field.weights[order[j]];
        }
        EXPECT_NEAR(field.smoothedEuclidean_m[i], sum / weight, 1e-12);
        EXPECT_NEAR(field.smoothedMahalanobis[i], squares / weight, 1e-9);
    }
}

TEST(Discrepancy, CropsStrictlyInsideTheReferenceAndBelowTheCropHeight) {
    ReferenceMap reference;
    reference.points = {{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};
    const std::vector<Eigen::Vector3d> map{{0.5, 0.5, 0.5}, {0.5, 0.5, 0.0},  {0.5, 1.0, 0.5},
                                           {0.5, 0.5, 0.8}, {-0.1, 0.5, 0.5}, {0.5, 0.5, 0.6}};
    DiscrepancySettings settings = settingsOf(0.01, 1);
    Progress progress;
    EXPECT_EQ(measureDiscrepancy(map, Transform::Identity(), reference, settings, progress).size(), 3u);
    settings.cropHeight_m = 0.6;
    EXPECT_EQ(measureDiscrepancy(map, Transform::Identity(), reference, settings, progress).size(), 1u);
    settings.cropToReference = false;
    EXPECT_EQ(measureDiscrepancy(map, Transform::Identity(), reference, settings, progress).size(), 4u);
    settings.cropHeight_m.reset();
    EXPECT_EQ(measureDiscrepancy(map, Transform::Identity(), reference, settings, progress).size(), 6u);
}

TEST(Discrepancy, VoxelsBeginAtTheLeastPointLeftByTheCrop) {
    ReferenceMap reference;
    reference.points = {{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};
    // From 0.105 on, voxels of 0.1 end at 0.205: the first two share one, from 0 on they would not.
    const std::vector<Eigen::Vector3d> map{{0.105, 0.5, 0.5}, {0.204, 0.5, 0.5}, {0.206, 0.5, 0.5}, {-3.0, 0.5, 0.5}};
    Progress progress;
    const DiscrepancyField field =
        measureDiscrepancy(map, Transform::Identity(), reference, settingsOf(0.1, 1), progress);
    EXPECT_EQ(field.weights, (std::vector<std::uint32_t>{2, 1}));
    EXPECT_EQ(field.smoothedEuclidean_m, field.euclidean_m);
}

TEST(Discrepancy, MovesTheMapIntoTheReferenceFrame) {
    ReferenceMap reference;
    reference.points = {{0.0, 0.0, 0.0}, {2.0, 2.0, 2.0}};
    Transform T_reference_from_map = Transform::Identity();
    T_reference_from_map.translation() = Eigen::Vector3d(1.0, 0.5, 0.25);
    const std::vector<Eigen::Vector3d> map{{0.0, 0.0, 0.0}};
    Progress progress;
    const DiscrepancyField field =
        measureDiscrepancy(map, T_reference_from_map, reference, settingsOf(0.1, 1), progress);
    EXPECT_EQ(field.points.front(), Eigen::Vector3d(1.0, 0.5, 0.25));
}

TEST(Discrepancy, IsUnknownWhereTheReferenceIsUntrained) {
    ReferenceMap reference;
    reference.points = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.5, 5.0, 5.0}, {0.5, -5.0, -5.0}};
    reference.covariance.assign(4, kCovariance);
    reference.covariance[1].setConstant(std::nan(""));
    reference.untrained = {0, 1, 0, 0};
    const std::vector<Eigen::Vector3d> map{{0.1, 0.0, 0.0}, {0.2, 0.0, 0.0}, {0.8, 0.0, 0.0}, {0.9, 0.0, 0.0}};
    Progress progress;
    const DiscrepancyField field =
        measureDiscrepancy(map, Transform::Identity(), reference, settingsOf(0.05, 2), progress);
    ASSERT_EQ(field.size(), 4u);
    EXPECT_FALSE(std::isnan(field.mahalanobis[1]));
    EXPECT_TRUE(std::isnan(field.mahalanobis[2]));
    EXPECT_FALSE(std::isnan(field.smoothedMahalanobis[0]));
    EXPECT_TRUE(std::isnan(field.smoothedMahalanobis[3]));
    // With a known neighbour the known part counts.
    const DiscrepancyField wider =
        measureDiscrepancy(map, Transform::Identity(), reference, settingsOf(0.05, 3), progress);
    EXPECT_DOUBLE_EQ(wider.smoothedMahalanobis[2], field.mahalanobis[1]);
    EXPECT_FALSE(std::isnan(wider.smoothedEuclidean_m[3]));
}

/// Σ w n d / Σ w n over a ball around each voxel, by the definition.
std::vector<double> smoothedInBalls(const DiscrepancyField& field, const std::vector<double>& values,
                                    const SmoothingSettings& settings) {
    std::vector<double> smoothed;
    for (const Eigen::Vector3d& centre : field.points) {
        double sum = 0.0;
        double weights = 0.0;
        for (std::size_t j = 0; j < field.size(); ++j) {
            const double r = (field.points[j] - centre).norm();
            if (r > settings.radius_m || std::isnan(values[j])) continue;
            const double weight =
                settings.weights == SmoothingWeights::Mean ? 1.0 : std::exp(-std::pow(r / settings.sigma_m, 2));
            sum += weight * field.weights[j] * values[j];
            weights += weight * field.weights[j];
        }
        smoothed.push_back(weights > 0.0 ? sum / weights : std::nan(""));
    }
    return smoothed;
}

TEST(Discrepancy, SmoothsInABallWithGaussianWeightsAndSeveralTimes) {
    const ReferenceMap reference = trainedCube();
    DiscrepancySettings settings = settingsOf(0.1, 7);
    settings.smoothing = {SmoothingNeighbourhood::Ball, 7, 0.3, SmoothingWeights::Gaussian, 0.1};
    settings.smoothingPasses = 2;
    Progress progress;
    const DiscrepancyField field =
        measureDiscrepancy(randomPoints(2000, 36), Transform::Identity(), reference, settings, progress);
    const auto twice = [&](const std::vector<double>& values) {
        return smoothedInBalls(field, smoothedInBalls(field, values, settings.smoothing), settings.smoothing);
    };
    const std::vector<double> euclidean_m = twice(field.euclidean_m);
    const std::vector<double> mahalanobis = twice(field.mahalanobis);
    for (std::size_t i = 0; i < field.size(); ++i) {
        EXPECT_NEAR(field.smoothedEuclidean_m[i], euclidean_m[i], 1e-12);
        EXPECT_NEAR(field.smoothedMahalanobis[i], mahalanobis[i], 1e-9);
    }
    settings.smoothingPasses = 0;
    EXPECT_EQ(measureDiscrepancy(randomPoints(2000, 36), Transform::Identity(), reference, settings, progress)
                  .smoothedEuclidean_m,
              field.euclidean_m);
}

TEST(Discrepancy, StaysUnknownInABallWhereNothingIsKnown) {
    ReferenceMap reference;
    reference.points = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.5, 5.0, 5.0}, {0.5, -5.0, -5.0}};
    reference.covariance.assign(4, kCovariance);
    reference.untrained = {0, 1, 0, 0};
    DiscrepancySettings settings = settingsOf(0.05, 1);
    settings.smoothing.neighbourhood = SmoothingNeighbourhood::Ball;
    settings.smoothing.radius_m = 0.15;
    settings.smoothing.weights = SmoothingWeights::Gaussian;
    settings.smoothingPasses = 3;
    Progress progress;
    const std::vector<Eigen::Vector3d> map{{0.1, 0.0, 0.0}, {0.2, 0.0, 0.0}, {0.8, 0.0, 0.0}, {0.9, 0.0, 0.0}};
    const DiscrepancyField field = measureDiscrepancy(map, Transform::Identity(), reference, settings, progress);
    ASSERT_EQ(field.size(), 4u);
    EXPECT_FALSE(std::isnan(field.smoothedMahalanobis[0]));
    EXPECT_FALSE(std::isnan(field.smoothedMahalanobis[1]));
    EXPECT_TRUE(std::isnan(field.smoothedMahalanobis[2]));
    EXPECT_TRUE(std::isnan(field.smoothedMahalanobis[3]));
    EXPECT_FALSE(std::isnan(field.smoothedEuclidean_m[3]));
}

TEST(Discrepancy, ComparesARandomShareOfThePoints) {
    const ReferenceMap reference = trainedCube();
    const auto map = randomPoints(2000, 37);
    DiscrepancySettings settings = settingsOf(0.1, 1);
    settings.cropToReference = false;
    settings.downSampling = DownSampling::Random;
    settings.randomRatio = 0.1;
    Progress progress;
    const auto measure = [&] { return measureDiscrepancy(map, Transform::Identity(), reference, settings, progress); };
    const DiscrepancyField field = measure();
    ASSERT_EQ(field.size(), 200u);
    EXPECT_EQ(field.weights, std::vector<std::uint32_t>(200, 1));
    auto next = map.begin();
    for (const Eigen::Vector3d& point : field.points) {
        next = std::find(next, map.end(), point);
        ASSERT_NE(next, map.end());
        ++next;
    }
    EXPECT_EQ(measure().points, field.points);
    settings.randomSeed = 2;
    EXPECT_NE(measure().points, field.points);
}

TEST(Discrepancy, MapPointsThatAreNotFiniteAreLeftOut) {
    const ReferenceMap reference = trainedCube();
    auto map = randomPoints(300, 39);
    Progress progress;
    DiscrepancySettings settings = settingsOf(0.1, 5);
    const auto expected = measureDiscrepancy(map, Transform::Identity(), reference, settings, progress);
    const double infinity = std::numeric_limits<double>::infinity();
    map.insert(map.begin() + 7, {std::nan(""), 0.5, 0.5});
    map.emplace_back(0.5, infinity, 0.5);
    map.emplace_back(0.5, 0.5, -infinity);
    for (const bool crop : {true, false}) {
        settings.cropToReference = crop;
        const auto field = measureDiscrepancy(map, Transform::Identity(), reference, settings, progress);
        for (const Eigen::Vector3d& point : field.points)
            EXPECT_TRUE(point.allFinite());
        if (crop) {
            EXPECT_EQ(field.smoothedMahalanobis, expected.smoothedMahalanobis);
        }
    }
}

TEST(Discrepancy, CoincidentPointsAndMoreNeighboursThanVoxelsAreNoProblem) {
    ReferenceMap reference = trainedCube();
    reference.points.insert(reference.points.end(), 3, reference.points.front());
    reference.covariance.assign(reference.size(), kCovariance);
    reference.untrained.assign(reference.size(), 0);
    const std::vector<Eigen::Vector3d> map(40, Eigen::Vector3d(0.5, 0.5, 0.5));
    DiscrepancySettings settings = settingsOf(0.1, 1000);
    settings.smoothing.weights = SmoothingWeights::Gaussian;
    Progress progress;
    const auto field = measureDiscrepancy(map, Transform::Identity(), reference, settings, progress);
    ASSERT_EQ(field.size(), 1u);
    EXPECT_EQ(field.weights.front(), 40u);
    EXPECT_DOUBLE_EQ(field.smoothedEuclidean_m.front(), field.euclidean_m.front());
    settings.downSampling = DownSampling::Random;
    settings.randomRatio = 0.5;
    const auto kept = measureDiscrepancy(map, Transform::Identity(), reference, settings, progress);
    EXPECT_EQ(kept.size(), 20u);
    EXPECT_DOUBLE_EQ(kept.smoothedMahalanobis.back(), kept.mahalanobis.front());
}

TEST(Discrepancy, ASingularCovarianceGivesNoDiscrepancy) {
    ReferenceMap reference = trainedCube();
    for (Eigen::Matrix3d& covariance : reference.covariance)
        covariance = Eigen::Vector3d(1e-3, 1e-3, 0.0).asDiagonal();
    Progress progress;
    const auto field =
        measureDiscrepancy(randomPoints(50, 40), Transform::Identity(), reference, settingsOf(0.1, 5), progress);
    for (std::size_t i = 0; i < field.size(); ++i) {
        EXPECT_TRUE(std::isnan(field.mahalanobis[i]));
        EXPECT_TRUE(std::isnan(field.smoothedMahalanobis[i]));
        EXPECT_FALSE(std::isnan(field.smoothedEuclidean_m[i]));
    }
}

TEST(Discrepancy, AllSettingsOutOfRangeAreToldAtOnce) {
    DiscrepancySettings settings = settingsOf(-1.0, 0);
    settings.randomRatio = 2.0;
    settings.smoothing.sigma_m = 0.0;
    settings.smoothingPasses = -1;
    Progress progress;
    try {
        measureDiscrepancy(randomPoints(50, 38), Transform::Identity(), trainedCube(), settings, progress);
        FAIL();
    } catch (const Error& error) {
        for (const char* part : {"voxel size", "random ratio", "neighbours", "sigma", "passes"})
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << part;
    }
}

TEST(Discrepancy, TellsWhenMahalanobisIsAskedForWithoutCovariances) {
    ReferenceMap reference;
    reference.points = randomPoints(20, 33);
    Progress progress;
    const DiscrepancyField field =
        measureDiscrepancy(randomPoints(100, 34), Transform::Identity(), reference, {}, progress);
    EXPECT_FALSE(field.hasMahalanobis());
    EXPECT_NO_THROW(field.smoothed(Metric::Euclidean));
    EXPECT_THROW(field.smoothed(Metric::Mahalanobis), Error);
}

TEST(Discrepancy, TheChiSquareMetricTestsTheEuclideanDiscrepancyWhenAskedFor) {
    Progress progress;
    const DiscrepancyField field =
        measureDiscrepancy(randomPoints(300, 36), Transform::Identity(), trainedCube(), settingsOf(0.1, 7), progress);
    EXPECT_FALSE(field.has(Metric::ChiSquare));
    EXPECT_THROW(field.smoothed(Metric::ChiSquare), Error);
    LocalStatisticalTestSettings settings;
    settings.distribution = TestDistribution::Weibull;
    settings.neighbours = 9;
    const DiscrepancyField tested = withChiSquare(field, settings, progress);
    EXPECT_TRUE(tested.has(Metric::ChiSquare));
    EXPECT_EQ(tested.smoothed(Metric::ChiSquare),
              localStatisticalTest(field.points, field.euclidean_m, settings, progress));
    EXPECT_EQ(tested.smoothedMahalanobis, field.smoothedMahalanobis);
}

TEST(Discrepancy, AMapThatIsTheReferenceLeavesNothingToTest) {
    ReferenceMap reference = trainedCube();
    Progress progress;
    DiscrepancySettings settings = settingsOf(1e-4, 1);
    settings.cropToReference = false;
    const DiscrepancyField field =
        measureDiscrepancy(reference.points, Transform::Identity(), reference, settings, progress);
    try {
        withChiSquare(field, {}, progress);
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "chi-square test: all values are equal, so that no distribution fits them; choose another metric");
    }
}

TEST(Discrepancy, RefusesAMapOutsideTheReferenceAndSettingsOutOfRange) {
    const ReferenceMap reference = trainedCube();
    const auto map = randomPoints(50, 35);
    Progress progress;
    const auto measure = [&](const DiscrepancySettings& settings, double shift) {
        Transform moved = Transform::Identity();
        moved.translation().x() = shift;
        return measureDiscrepancy(map, moved, reference, settings, progress);
    };
    EXPECT_THROW(measure(settingsOf(0.1, 1), 100.0), Error);
    EXPECT_THROW(measure(settingsOf(0.0, 1), 0.0), Error);
    EXPECT_THROW(measure(settingsOf(0.1, 0), 0.0), Error);
    DiscrepancySettings settings = settingsOf(0.1, 1);
    settings.cropHeight_m = std::nan("");
    EXPECT_THROW(measure(settings, 0.0), Error);
    EXPECT_THROW(measureDiscrepancy({}, Transform::Identity(), reference, {}, progress), Error);
    EXPECT_THROW(measureDiscrepancy(map, Transform::Identity(), {}, {}, progress), Error);
    progress.cancel();
    EXPECT_THROW(measure(settingsOf(0.1, 1), 0.0), Cancelled);
}

}  // namespace
}  // namespace fodscope
