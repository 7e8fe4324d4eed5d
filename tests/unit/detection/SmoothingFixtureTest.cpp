// SPDX-License-Identifier: MIT
// Every form of smoothing of covariances and discrepancies against numpy and scipy;
// tests/data/smoothing/make_fixture.py computed the tables. Covariances agree within 1e-5 of their greatest entry,
// discrepancies within 1e-4 of their value, and the same points are untrained or unknown.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/detection/Discrepancy.h"
#include "core/reference/CovarianceFit.h"
#include "tests/acceptance/CsvTable.h"

namespace fodscope {
namespace {

constexpr double kCovarianceShare = 1e-5;
constexpr double kDiscrepancyShare = 1e-4;
constexpr std::array<const char*, 6> kNames{"xx", "xy", "xz", "yy", "yz", "zz"};
constexpr std::array<std::pair<int, int>, 6> kEntries{{{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};

CsvTable table(const std::string& name) {
    return CsvTable(std::filesystem::path(FODSCOPE_TEST_DATA) / "smoothing" / name, true);
}

std::vector<Eigen::Vector3d> pointsOf(const CsvTable& rows) {
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i < rows.rows(); ++i)
        points.emplace_back(rows["x"][i], rows["y"][i], rows["z"][i]);
    return points;
}

Eigen::Matrix3d matrixAt(const CsvTable& rows, const std::string& prefix, std::size_t row) {
    Eigen::Matrix3d matrix;
    for (std::size_t entry = 0; entry < kEntries.size(); ++entry) {
        const auto [a, b] = kEntries[entry];
        matrix(a, b) = matrix(b, a) = rows[prefix + "_" + kNames[entry]][row];
    }
    return matrix;
}

/// "knn12_gaussian_voxel": k, or a ball; the weights; and what was done besides.
SmoothingSettings smoothingOf(const std::string& form) {
    SmoothingSettings settings;
    if (form.starts_with("ball")) settings.neighbourhood = SmoothingNeighbourhood::Ball;
    if (form.starts_with("knn")) settings.neighbours = std::stoi(form.substr(3));
    if (form.find("gaussian") != std::string::npos) settings.weights = SmoothingWeights::Gaussian;
    settings.radius_m = 0.2;
    settings.sigma_m = 0.05;
    return settings;
}

ReferenceMap sampledReference() {
    ReferenceMap reference;
    reference.points = pointsOf(table("reference.csv"));
    Progress progress;
    collectScatter(pointsOf(table("samples.csv")), reference, progress);
    return reference;
}

ReferenceMap fittedReference(const std::string& form) {
    CovarianceFitSettings settings;
    settings.smoothing = smoothingOf(form);
    if (form.find("voxel") != std::string::npos) settings.smoothingVoxelSize_m = 0.15;
    if (form.find("regularised") != std::string::npos) settings.regularisation_m2 = 1e-6;
    ReferenceMap reference = sampledReference();
    Progress progress;
    fitCovariances(reference, settings, progress);
    return reference;
}

TEST(SmoothingFixture, ScatterAgrees) {
    const ReferenceMap reference = sampledReference();
    const CsvTable expected = table("covariances.csv");
    ASSERT_EQ(reference.size(), expected.rows());
    for (std::size_t i = 0; i < reference.size(); ++i) {
        EXPECT_EQ(reference.sampleCount[i], expected["n"][i]);
        const Eigen::Matrix3d scatter = matrixAt(expected, "S", i);
        EXPECT_LE((reference.scatter[i] - scatter).cwiseAbs().maxCoeff(),
                  kCovarianceShare * scatter.cwiseAbs().maxCoeff());
    }
}

class CovarianceFixture : public testing::TestWithParam<const char*> {};

TEST_P(CovarianceFixture, Agrees) {
    const ReferenceMap reference = fittedReference(GetParam());
    const CsvTable expected = table("covariances.csv");
    ASSERT_EQ(reference.size(), expected.rows());
    for (std::size_t i = 0; i < reference.size(); ++i) {
        const Eigen::Matrix3d covariance = matrixAt(expected, GetParam(), i);
        ASSERT_EQ(reference.untrained[i] != 0, std::isnan(covariance(0, 0))) << "row " << i;
        if (reference.untrained[i] != 0) continue;
        EXPECT_LE((reference.covariance[i] - covariance).cwiseAbs().maxCoeff(),
                  kCovarianceShare * covariance.cwiseAbs().maxCoeff())
            << "row " << i;
    }
}

INSTANTIATE_TEST_SUITE_P(AllForms, CovarianceFixture,
                         testing::Values("knn12_mean", "knn12_mean_voxel", "knn12_mean_regularised", "knn12_gaussian",
                                         "knn12_gaussian_voxel", "knn12_gaussian_regularised", "knn1_mean",
                                         "knn1_gaussian", "knn1000_mean", "knn1000_gaussian", "ball_mean",
                                         "ball_mean_voxel", "ball_mean_regularised", "ball_gaussian",
                                         "ball_gaussian_voxel", "ball_gaussian_regularised"));

void expectClose(const std::vector<double>& computed, const std::vector<double>& expected) {
    ASSERT_EQ(computed.size(), expected.size());
    for (std::size_t i = 0; i < computed.size(); ++i) {
        ASSERT_EQ(std::isnan(computed[i]), std::isnan(expected[i])) << "row " << i;
        if (std::isnan(expected[i])) continue;
        EXPECT_LE(std::abs(computed[i] - expected[i]), kDiscrepancyShare * expected[i]) << "row " << i;
    }
}

class DiscrepancyFixture : public testing::TestWithParam<const char*> {};

TEST_P(DiscrepancyFixture, Agrees) {
    const std::string form = GetParam();
    const ReferenceMap reference = fittedReference("ball_mean");
    const CsvTable expected = table("discrepancy.csv");
    DiscrepancySettings settings;
    settings.voxelSize_m = 0.04;
    settings.smoothing = smoothingOf(form);
    for (const int passes : {1, 3}) {
        settings.smoothingPasses = passes;
        Progress progress;
        const DiscrepancyField field =
            measureDiscrepancy(pointsOf(table("map.csv")), Transform::Identity(), reference, settings, progress);
        ASSERT_EQ(field.size(), expected.rows());
        expectClose(field.euclidean_m, expected["euclidean"]);
        expectClose(field.mahalanobis, expected["mahalanobis"]);
        const std::string column = form + "_" + std::to_string(passes);
        expectClose(field.smoothedEuclidean_m, expected[column + "_euclidean"]);
        expectClose(field.smoothedMahalanobis, expected[column + "_mahalanobis"]);
    }
}

INSTANTIATE_TEST_SUITE_P(AllForms, DiscrepancyFixture,
                         testing::Values("knn9_mean", "knn9_gaussian", "knn5000_mean", "knn5000_gaussian", "ball_mean",
                                         "ball_gaussian"));

}  // namespace
}  // namespace fodscope
