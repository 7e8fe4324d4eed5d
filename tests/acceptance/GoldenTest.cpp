// SPDX-License-Identifier: MIT
// The reference and the detection on the real tank against the numbers of an independent implementation (numpy, scipy),
// computed from the same maps with the same transforms.
//
// Tolerances. The golden tables have 9 significant digits, so a number agrees at best to half a unit in the last one:
// 5e-10 relative. Coordinates below 10 m are thus printed to 5e-9 m; 1e-8 m allows for that and for sums added up in
// another order. Scatters and covariances are sums of squares of differences of coordinates; 1e-5 of the matrix's
// greatest entry is far above rounding and far below one sample more or less. Discrepancies, which pass through the
// inverse of a covariance, agree to 1e-6 of their value and 1e-8. Counts, indices and labels are equal. One thing is
// not defined by the recipe: which of several voxels at the same distance is the 50th neighbour of another. The
// smoothed discrepancy may therefore differ in `kTiedRows` rows of 122 998.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/cloud/OutlierRemoval.h"
#include "core/cloud/PointCloudIo.h"
#include "core/common/Files.h"
#include "core/detection/Candidates.h"
#include "core/detection/Discrepancy.h"
#include "core/reference/MeanReference.h"
#include "core/reference/ReferenceMapIo.h"
#include "tests/acceptance/CsvTable.h"
#include "tests/acceptance/SharedData.h"

namespace fodscope {
namespace {

constexpr double kCoordinate_m = 1e-8;
constexpr double kMatrixShare = 1e-5;
constexpr double kDiscrepancyShare = 1e-6;
constexpr std::size_t kTiedRows = 20;

std::filesystem::path tank() {
    return sharedData() / "nuwc-tank";
}

Transform transformAt(const CsvTable& table, std::size_t row) {
    std::array<double, 16> rows{};
    for (std::size_t i = 0; i < 16; ++i) {
        std::string name = "m00";
        name[1] = static_cast<char>('0' + i / 4);
        name[2] = static_cast<char>('0' + i % 4);
        rows[i] = table[name][row];
    }
    return transformFromRows(rows, "train_transforms.csv");
}

Transform queryTransform() {
    const CsvTable table(tank() / "golden/query_val_03_T.csv", false);
    std::array<double, 16> rows{};
    for (std::size_t i = 0; i < 16; ++i)
        rows[i] = table[std::to_string(i % 4)][i / 4];
    return transformFromRows(rows, "query_val_03_T.csv");
}

ReferenceMap buildReference() {
    const CsvTable transforms(tank() / "golden/train_transforms.csv", true);
    std::vector<PointCloud> maps;
    for (std::size_t i = 0; i < transforms.rows(); ++i) {
        std::array<char, 32> name{};
        std::snprintf(name.data(), name.size(), "train_%02zu.pcd", i);
        maps.push_back(readPointCloud(tank() / name.data()));
    }
    std::vector<AlignedNominalMap> aligned;
    for (std::size_t i = 0; i < maps.size(); ++i)
        aligned.push_back({&maps[i], transformAt(transforms, i)});
    Progress progress;
    return meanReference(aligned, {}, progress);
}

/// What all tests look at, made once.
struct Inspected {
    ReferenceMap reference;
    PointCloud denoised;
    std::size_t rawPoints = 0;
    DiscrepancyField field;
};

DiscrepancySettings querySettings() {
    DiscrepancySettings settings;
    settings.cropHeight_m = 0.60;
    return settings;
}

Inspected inspect() {
    Inspected inspected;
    inspected.reference = buildReference();
    const PointCloud map = readPointCloud(tank() / "val_03.pcd");
    Progress progress;
    inspected.rawPoints = map.size();
    inspected.denoised = select(map, keptByOutlierRemoval(map.points, {}, progress));
    inspected.field =
        measureDiscrepancy(inspected.denoised.points, queryTransform(), inspected.reference, querySettings(), progress);
    return inspected;
}

class Golden : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        if (std::filesystem::exists(tank() / "golden/params.json")) inspected_.emplace(inspect());
    }
    static void TearDownTestSuite() { inspected_.reset(); }

    void SetUp() override {
        if (!inspected_) {
            GTEST_SKIP() << "the tank's data is not at " << tank() << " (set FODSCOPE_SHARED_DATA to its parent)";
        }
        parameters_ = nlohmann::json::parse(readTextFile(tank() / "golden/params.json"));
    }

    const ReferenceMap& reference() const { return inspected_->reference; }
    const DiscrepancyField& field() const { return inspected_->field; }

    CandidateSettings candidateSettings(Metric metric) const {
        const nlohmann::json& golden = parameters_["detect"][metric == Metric::Mahalanobis ? "M" : "L2"];
        CandidateSettings settings;
        settings.metric = metric;
        settings.threshold = golden["threshold"];
        settings.clusterCutoff_m = golden["cutoff"];
        settings.minimumPoints = golden["min_points"];
        return settings;
    }

    CandidateSet candidates(const DiscrepancyField& measured, Metric metric) const {
        Progress progress;
        return findCandidates(measured, candidateSettings(metric), querySettings().voxelSize_m,
                              floorHeight(reference()), queryTransform(), progress);
    }

    static std::optional<Inspected> inspected_;
    nlohmann::json parameters_;
};

std::optional<Inspected> Golden::inspected_;

/// Counts the rows in which the computed value is not the golden one.
template <class Computed>
std::size_t rowsThatDiffer(const Computed& computed, const std::vector<double>& golden) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < golden.size(); ++i)
        count += static_cast<double>(computed[i]) != golden[i];
    return count;
}

/// Counts the rows farther from the golden ones than the share of their value, and 1e-8.
std::size_t rowsBeyond(const std::vector<double>& computed, const std::vector<double>& golden, double share) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < golden.size(); ++i)
        count += !(std::abs(computed[i] - golden[i]) <= share * std::abs(golden[i]) + 1e-8);
    return count;
}

std::size_t pointsBeyond(const std::vector<Eigen::Vector3d>& computed, const CsvTable& golden, double distance_m) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < golden.rows(); ++i) {
        const Eigen::Vector3d point(golden["x"][i], golden["y"][i], golden["z"][i]);
        count += !((computed[i] - point).cwiseAbs().maxCoeff() <= distance_m);
    }
    return count;
}

std::size_t matricesBeyond(const std::vector<Eigen::Matrix3d>& computed, const CsvTable& golden, char prefix) {
    static constexpr std::array<const char*, 6> names{"xx", "xy", "xz", "yy", "yz", "zz"};
    static constexpr std::array<std::pair<int, int>, 6> entries{{{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};
    std::size_t count = 0;
    for (std::size_t i = 0; i < golden.rows(); ++i) {
        const double tolerance = kMatrixShare * computed[i].cwiseAbs().maxCoeff();
        bool agrees = true;
        for (std::size_t entry = 0; entry < entries.size(); ++entry) {
            const double value = computed[i](entries[entry].first, entries[entry].second);
            agrees = agrees && std::abs(value - golden[prefix + std::string(names[entry])][i]) <= tolerance;
        }
        count += !agrees;
    }
    return count;
}

TEST_F(Golden, ReferenceAgrees) {
    const CsvTable golden(tank() / "golden/reference.csv", true);
    ASSERT_EQ(reference().size(), golden.rows());
    EXPECT_EQ(pointsBeyond(reference().points, golden, kCoordinate_m), 0u);
    EXPECT_EQ(rowsThatDiffer(reference().occupancy, golden["occupancy"]), 0u);
    EXPECT_EQ(rowsThatDiffer(reference().sampleCount, golden["n_samples"]), 0u);
    EXPECT_EQ(matricesBeyond(reference().scatter, golden, 'S'), 0u);
    EXPECT_EQ(matricesBeyond(reference().covariance, golden, 'C'), 0u);
    EXPECT_EQ(std::count(reference().untrained.begin(), reference().untrained.end(), 1), 0);
}

TEST_F(Golden, FloorIsWhereTheModelHasIt) {
    // The plate lies at 0; what stands on it and the sensor's noise lift its voxels by millimetres.
    EXPECT_NEAR(floorHeight(reference()), 0.0, 0.01);
}

TEST_F(Golden, MeanCloudIsTheReferenceInSinglePrecision) {
    const PointCloud golden = readPointCloud(tank() / "golden/mean_cloud.pcd");
    ASSERT_EQ(golden.size(), reference().size());
    double greatest = 0.0;
    for (std::size_t i = 0; i < golden.size(); ++i)
        greatest = std::max(greatest, (golden.points[i] - reference().points[i]).cwiseAbs().maxCoeff());
    // Half a unit in the last place of a float between 4 and 8.
    EXPECT_LE(greatest, 2.5e-7);
}

TEST_F(Golden, DenoisedQueryHasTheGoldenNumberOfPoints) {
    EXPECT_EQ(inspected_->rawPoints, parameters_["raw_points"].get<std::size_t>());
    EXPECT_EQ(inspected_->denoised.size(), parameters_["sor_kept"].get<std::size_t>());
}

TEST_F(Golden, DiscrepancyAgrees) {
    const CsvTable golden(tank() / "golden/query_val_03.csv", true);
    ASSERT_EQ(field().size(), golden.rows());
    EXPECT_EQ(pointsBeyond(field().points, golden, kCoordinate_m), 0u);
    EXPECT_EQ(rowsThatDiffer(field().weights, golden["n"]), 0u);
    EXPECT_EQ(rowsThatDiffer(field().nearest, golden["nearest"]), 0u);
    EXPECT_EQ(rowsBeyond(field().euclidean_m, golden["L2"], kDiscrepancyShare), 0u);
    EXPECT_EQ(rowsBeyond(field().mahalanobis, golden["M"], kDiscrepancyShare), 0u);
    EXPECT_LE(rowsBeyond(field().smoothedEuclidean_m, golden["L2_smooth"], kDiscrepancyShare), kTiedRows);
    EXPECT_LE(rowsBeyond(field().smoothedMahalanobis, golden["M_smooth"], kDiscrepancyShare), kTiedRows);
}

struct GoldenCluster {
    std::size_t points = 0;
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
};

std::map<int, GoldenCluster> goldenClusters(const std::string& metric) {
    const CsvTable table(tank() / ("golden/candidates_" + metric + ".csv"), true);
    std::map<int, GoldenCluster> clusters;
    for (std::size_t i = 0; i < table.rows(); ++i) {
        clusters[static_cast<int>(table["label"][i])] = {static_cast<std::size_t>(table["points"][i]),
                                                         {table["x"][i], table["y"][i], table["z"][i]}};
    }
    return clusters;
}

/// Checks number, size, centroid and the voxels of the candidates.
void expectGoldenCandidates(const CandidateSet& set, const std::string& metric) {
    const std::map<int, GoldenCluster> clusters = goldenClusters(metric);
    const CsvTable query(tank() / "golden/query_val_03.csv", true);
    const std::vector<double>& labels = query["label_" + metric];
    EXPECT_EQ(set.pointsAboveThreshold,
              labels.size() - static_cast<std::size_t>(std::count(labels.begin(), labels.end(), -1.0)));
    ASSERT_EQ(set.candidates.size(), clusters.size());
    for (const Candidate& candidate : set.candidates) {
        const int label = static_cast<int>(labels[candidate.voxels.front()]);
        ASSERT_TRUE(clusters.contains(label)) << candidate.id;
        const GoldenCluster& golden = clusters.at(label);
        EXPECT_EQ(candidate.voxels.size(), golden.points);
        EXPECT_LE((candidate.centroid_reference - golden.centroid).norm(), kCoordinate_m * 2.0) << candidate.id;
        EXPECT_TRUE(std::all_of(candidate.voxels.begin(), candidate.voxels.end(), [&](std::uint32_t voxel) {
            return labels[voxel] == label;
        })) << candidate.id;
    }
}

TEST_F(Golden, MahalanobisCandidatesAgree) {
    expectGoldenCandidates(candidates(field(), Metric::Mahalanobis), "M");
}

TEST_F(Golden, EuclideanCandidatesAgree) {
    expectGoldenCandidates(candidates(field(), Metric::Euclidean), "L2");
}

/// A file holds float32: coordinates are off by up to 2.4e-7 m, which shows in the Euclidean discrepancy as it is, and
/// in Mahalanobis as some 1e-5. A voxel that lies as near to two reference points may go to the other one and get that
/// one's covariance; such voxels are few, and each counts in the smoothed values of about 50.
TEST_F(Golden, ReferenceReadBackFromItsFileGivesTheSameDetection) {
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "fodscope-golden-reference.ply";
    writeReferenceMap(file, reference());
    const ReferenceMap again = readReferenceMap(file);
    std::filesystem::remove(file);
    ASSERT_EQ(again.size(), reference().size());
    EXPECT_EQ(again.occupancy, reference().occupancy);
    EXPECT_EQ(again.sampleCount, reference().sampleCount);
    EXPECT_EQ(again.provenance, reference().provenance);
    Progress progress;
    const DiscrepancyField measured =
        measureDiscrepancy(inspected_->denoised.points, queryTransform(), again, querySettings(), progress);
    ASSERT_EQ(measured.size(), field().size());
    std::size_t switched = 0;
    std::size_t beyond = 0;
    double greatestUnsmoothed = 0.0;
    double greatestEuclidean_m = 0.0;
    for (std::size_t i = 0; i < field().size(); ++i) {
        const auto difference = [i](const std::vector<double>& a, const std::vector<double>& b) {
            return std::abs(a[i] - b[i]);
        };
        beyond += difference(measured.smoothedMahalanobis, field().smoothedMahalanobis) > 1e-4;
        greatestEuclidean_m =
            std::max(greatestEuclidean_m, difference(measured.smoothedEuclidean_m, field().smoothedEuclidean_m));
        if (measured.nearest[i] == field().nearest[i]) {
            greatestUnsmoothed = std::max(greatestUnsmoothed, difference(measured.mahalanobis, field().mahalanobis));
        } else {
            ++switched;
        }
    }
    EXPECT_LE(greatestEuclidean_m, 1e-6);
    EXPECT_LE(greatestUnsmoothed, 1e-4);
    EXPECT_LE(switched, 10u);
    EXPECT_LE(beyond, 60 * switched);
    const CandidateSet before = candidates(field(), Metric::Mahalanobis);
    const CandidateSet after = candidates(measured, Metric::Mahalanobis);
    ASSERT_EQ(after.candidates.size(), before.candidates.size());
    for (std::size_t i = 0; i < after.candidates.size(); ++i) {
        const Candidate& a = after.candidates[i];
        const Candidate& b = before.candidates[i];
        EXPECT_EQ(a.voxels, b.voxels) << a.id;
        EXPECT_NEAR(a.discrepancyMax, b.discrepancyMax, 1e-4) << a.id;
    }
}

}  // namespace
}  // namespace fodscope
