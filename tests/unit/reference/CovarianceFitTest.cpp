// SPDX-License-Identifier: MIT
// The forms of covariance fitting one by one; CovarianceFixtureTest compares all of them with numpy and scipy.
#include "core/reference/CovarianceFit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/reference/Covariance.h"
#include "tests/unit/cloud/ExpectError.h"
#include "tests/unit/cloud/RandomPoints.h"

namespace fodscope {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

CovarianceFitSettings nearest(int neighbours) {
    CovarianceFitSettings settings;
    settings.smoothing.neighbours = neighbours;
    return settings;
}

CovarianceFitSettings gaussianBall(double radius_m, double sigma_m) {
    CovarianceFitSettings settings;
    settings.smoothing.neighbourhood = SmoothingNeighbourhood::Ball;
    settings.smoothing.radius_m = radius_m;
    settings.smoothing.weights = SmoothingWeights::Gaussian;
    settings.smoothing.sigma_m = sigma_m;
    return settings;
}

/// Points along x with a scatter that their number of samples makes.
ReferenceMap line(const std::vector<double>& xs, const std::vector<std::int32_t>& counts) {
    ReferenceMap reference;
    for (std::size_t i = 0; i < xs.size(); ++i) {
        reference.points.emplace_back(xs[i], 0.0, 0.0);
        reference.scatter.push_back(counts[i] * Eigen::Vector3d(1e-4, 2e-4, 3e-4).asDiagonal().toDenseMatrix());
    }
    reference.sampleCount = counts;
    return reference;
}

void fit(ReferenceMap& reference, const CovarianceFitSettings& settings) {
    Progress progress;
    fitCovariances(reference, settings, progress);
}

TEST(CovarianceFit, MarksWhatTheSamplesDoNotSupportAsUntrained) {
    ReferenceMap reference = line({0.0, 0.1, 5.0, 5.1, 9.0}, {3, 0, 0, 0, 8});
    // All samples of the last point lie in a plane: without extent across it there is no Mahalanobis distance.
    reference.scatter[4] = Eigen::Vector3d(1e-3, 1e-3, 0.0).asDiagonal();
    fit(reference, nearest(2));
    EXPECT_EQ(reference.untrained, (std::vector<std::uint8_t>{0, 0, 1, 1, 1}));
    EXPECT_TRUE(reference.covariance[1].isApprox(reference.scatter[0] / 3.0));
    for (const std::size_t i : {2, 3, 4})
        EXPECT_TRUE(reference.covariance[i].array().isNaN().all());
}

TEST(CovarianceFit, RegularisationMakesAPlaneInvertibleAndLeavesWhereNothingIsKnownUntrained) {
    ReferenceMap reference = line({0.0, 5.0}, {8, 0});
    reference.scatter[0] = Eigen::Vector3d(8e-3, 8e-3, 0.0).asDiagonal();
    CovarianceFitSettings settings = nearest(1);
    settings.regularisation_m2 = 1e-4;
    fit(reference, settings);
    EXPECT_EQ(reference.untrained, (std::vector<std::uint8_t>{0, 1}));
    EXPECT_TRUE(
        reference.covariance[0].isApprox(Eigen::Vector3d(1.1e-3, 1.1e-3, 1e-4).asDiagonal().toDenseMatrix(), 1e-12));
    EXPECT_TRUE(reference.covariance[1].array().isNaN().all());
}

TEST(CovarianceFit, ASingleSampleHasNoUnbiasedCovariance) {
    // V1 = V2 / V1 for the only sample, at the point and beside it, where rounding must not make it a small number.
    for (const double x : {0.0, 0.03, 0.0471, 0.1}) {
        ReferenceMap reference = line({0.0, x == 0.0 ? 7.0 : x}, {x == 0.0 ? 1 : 0, x == 0.0 ? 0 : 1});
        fit(reference, gaussianBall(0.2, 0.05));
        EXPECT_EQ(reference.untrained.front(), 1) << x;
        EXPECT_TRUE(std::isnan(reference.covariance.front()(0, 0))) << x;
    }
}

TEST(CovarianceFit, TwoSamplesAtOnePlaceAreDividedByOne) {
    ReferenceMap reference = line({0.0, 0.03}, {0, 2});
    fit(reference, gaussianBall(0.2, 0.05));
    EXPECT_EQ(reference.untrained, (std::vector<std::uint8_t>{0, 0}));
    for (const Eigen::Matrix3d& covariance : reference.covariance)
        EXPECT_TRUE(covariance.isApprox(reference.scatter[1], 1e-12));
}

TEST(CovarianceFit, AFarNeighbourCountsAsLongAsItsWeightIsNotZero) {
    // 20 σ away: the weight is 2e-174, its square vanishes in double. 30 σ away the weight itself does.
    ReferenceMap reference = line({0.0, 1.0}, {0, 4});
    CovarianceFitSettings settings = nearest(2);
    settings.smoothing.weights = SmoothingWeights::Gaussian;
    settings.smoothing.sigma_m = 0.05;
    fit(reference, settings);
    EXPECT_EQ(reference.untrained.front(), 0);
    EXPECT_TRUE(reference.covariance.front().isApprox(reference.scatter[1] / 3.0, 1e-12));
    settings.smoothing.sigma_m = 1.0 / 30.0;
    fit(reference, settings);
    EXPECT_EQ(reference.untrained, (std::vector<std::uint8_t>{1, 0}));
}

TEST(CovarianceFit, AnEmptyBallIsUntrained) {
    ReferenceMap reference = line({0.0, 1.0}, {0, 5});
    CovarianceFitSettings settings = gaussianBall(0.5, 0.05);
    fit(reference, settings);
    EXPECT_EQ(reference.untrained, (std::vector<std::uint8_t>{1, 0}));
    settings.smoothing.weights = SmoothingWeights::Mean;
    fit(reference, settings);
    EXPECT_EQ(reference.untrained, (std::vector<std::uint8_t>{1, 0}));
    ReferenceMap without = line({0.0, 1.0}, {0, 0});
    fit(without, settings);
    EXPECT_EQ(without.untrained, (std::vector<std::uint8_t>{1, 1}));
}

TEST(CovarianceFit, CoincidentPointsShareTheirSamples) {
    ReferenceMap reference = line({0.5, 0.5, 0.5}, {4, 0, 2});
    fit(reference, gaussianBall(0.2, 0.05));
    EXPECT_EQ(reference.untrained, (std::vector<std::uint8_t>{0, 0, 0}));
    EXPECT_EQ(reference.covariance[0], reference.covariance[1]);
    EXPECT_TRUE(reference.covariance[0].isApprox((reference.scatter[0] + reference.scatter[2]) / 5.0, 1e-12));
}

TEST(CovarianceFit, MoreNeighboursThanPointsAreAllPoints) {
    ReferenceMap reference = line({0.0, 0.3, 0.6}, {1, 2, 3});
    fit(reference, nearest(1000));
    for (const Eigen::Matrix3d& covariance : reference.covariance)
        EXPECT_TRUE(covariance.isApprox(Eigen::Vector3d(1e-4, 2e-4, 3e-4).asDiagonal().toDenseMatrix(), 1e-12));
}

TEST(CovarianceFit, InVoxelsEveryPointTakesTheNearestMeansCovariance) {
    ReferenceMap reference = line({0.01, 0.03, 0.06, 0.55, 0.56, 0.6}, {3, 0, 5, 2, 4, 7});
    reference.scatter[4] *= 9.0;
    CovarianceFitSettings settings = nearest(1);
    settings.smoothingVoxelSize_m = 0.2;
    fit(reference, settings);
    // The means are at 0.033 and 0.57: nearest to them are the points at 0.03, without samples, and at 0.56.
    EXPECT_EQ(reference.untrained, (std::vector<std::uint8_t>{1, 1, 1, 0, 0, 0}));
    for (const std::size_t i : {3, 4, 5})
        EXPECT_TRUE(reference.covariance[i].isApprox(reference.scatter[4] / 4.0, 1e-12));
}

TEST(CovarianceFit, AllSettingsOutOfRangeAreToldAtOnce) {
    CovarianceFitSettings settings = gaussianBall(-0.2, 0.0);
    settings.smoothing.neighbours = -3;
    settings.smoothingVoxelSize_m = 0.0;
    settings.regularisation_m2 = kNan;
    EXPECT_EQ(covarianceFitProblems(settings).size(), 5u);
    ReferenceMap reference = line({0.0, 1.0}, {1, 1});
    for (const char* part : {"neighbours", "radius", "sigma", "smoothing voxel", "regularisation"})
        expectError([&] { fit(reference, settings); }, part);
}

TEST(CovarianceFit, RefusesAReferenceWithoutScatterAndSamplesThatAreNotFinite) {
    ReferenceMap bare;
    bare.points = randomPoints(10, 81);
    expectError([&] { fit(bare, nearest(3)); }, "no scatter");
    ReferenceMap empty;
    Progress progress;
    expectError([&] { collectScatter(randomPoints(10, 82), empty, progress); }, "no points");
    bare.points.front().x() = kNan;
    expectError([&] { collectScatter(randomPoints(10, 82), bare, progress); }, "not finite");
    ReferenceMap reference = line({0.0, 1.0}, {1, 1});
    for (const double bad : {kNan, std::numeric_limits<double>::infinity()}) {
        const std::vector<Eigen::Vector3d> samples{{0.1, 0.0, 0.0}, {0.1, bad, 0.0}};
        expectError([&] { collectScatter(samples, reference, progress); }, "not finite");
    }
    progress.cancel();
    EXPECT_THROW(fitCovariances(reference, nearest(1), progress), Cancelled);
}

TEST(CovarianceFit, ProvenanceTellsTheFormThatWasUsed) {
    EXPECT_EQ(provenanceOf(nearest(250)), "covariance_neighbours 250");
    CovarianceFitSettings settings = gaussianBall(0.2, 0.05);
    settings.smoothingVoxelSize_m = 0.1;
    settings.regularisation_m2 = 1e-6;
    EXPECT_EQ(provenanceOf(settings),
              "covariance_radius_m 0.2 covariance_sigma_m 0.05 covariance_voxel_size_m 0.1 "
              "covariance_regularisation_m2 1e-06");
}

}  // namespace
}  // namespace fodscope
