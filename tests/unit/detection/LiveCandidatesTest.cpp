// SPDX-License-Identifier: MIT
// Candidates that follow moved settings are those found from scratch, to the bit.
#include "core/detection/LiveCandidates.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "core/common/Error.h"

namespace fodscope {
namespace {

class Dice {
  public:
    explicit Dice(std::uint64_t seed) : generator_(seed) {}

    double unit() { return static_cast<double>(generator_() >> 11) * 0x1.0p-53; }
    double between(double low, double high) { return low + (high - low) * unit(); }
    std::size_t below(std::size_t count) { return generator_() % count; }

  private:
    std::mt19937_64 generator_;
};

enum class Places { Clumps, Lattice, Surface };

Eigen::Vector3d place(Places places, Dice& dice) {
    const Eigen::Vector3d random(dice.unit(), dice.unit(), dice.unit());
    switch (places) {
        case Places::Clumps: {
            const auto clump = static_cast<double>(dice.below(9));
            return Eigen::Vector3d(clump, std::fmod(2.0 * clump, 3.0), 0.0) + 0.3 * random;
        }
        case Places::Lattice:
            return 0.1 * (12.0 * random).array().floor();
        case Places::Surface:
            return {3.0 * random.x(), 2.0 * random.y(), 0.02 * random.z()};
    }
    return random;
}

/// Many voxels share a discrepancy, and some have none.
std::shared_ptr<const DiscrepancyField> fieldOf(Places places, std::size_t voxels, Dice& dice) {
    auto field = std::make_shared<DiscrepancyField>();
    for (std::size_t i = 0; i < voxels; ++i) {
        field->points.push_back(place(places, dice));
        const double value = dice.unit() < 0.5 ? std::floor(dice.between(0.0, 40.0)) / 10.0 : dice.between(0.0, 4.0);
        field->smoothedMahalanobis.push_back(dice.unit() < 0.02 ? std::nan("") : value);
        field->smoothedEuclidean_m.push_back(dice.between(0.0, 0.1));
    }
    field->weights.assign(voxels, 1);
    field->nearest.assign(voxels, 0);
    field->euclidean_m = field->smoothedEuclidean_m;
    field->mahalanobis = field->smoothedMahalanobis;
    return field;
}

Transform someTransform() {
    Transform T_reference_from_map(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()));
    T_reference_from_map.translation() = Eigen::Vector3d(1.0, -2.0, 0.1);
    return T_reference_from_map;
}

/// As hands move the settings: mostly a step of one slider, now and then something else altogether.
void move(CandidateSettings& settings, Dice& dice) {
    switch (dice.below(12)) {
        case 0:
            settings.threshold = dice.between(0.0, 4.2);
            break;
        case 1:
            settings.threshold = std::floor(dice.between(0.0, 40.0)) / 10.0;
            break;
        case 2:
        case 3:
        case 4:
            settings.threshold = std::max(0.0, settings.threshold + dice.between(-0.2, 0.2));
            break;
        case 5:
            settings.clusterCutoff_m = dice.below(4) == 0 ? 0.0 : 0.1 * static_cast<double>(dice.below(8));
            break;
        case 6:
        case 7:
        case 8:
            settings.clusterCutoff_m = std::max(0.0, settings.clusterCutoff_m + dice.between(-0.05, 0.05));
            break;
        case 9:
            settings.minimumPoints = static_cast<int>(dice.below(9));
            break;
        case 10:
            settings.centroid =
                settings.centroid == CentroidKind::Plain ? CentroidKind::DiscrepancyWeighted : CentroidKind::Plain;
            break;
        case 11:
            if (dice.below(3) == 0)
                settings.linkage = settings.linkage == Linkage::Centroid ? Linkage::Single : Linkage::Centroid;
            else if (dice.below(3) == 0)
                settings.metric = settings.metric == Metric::Mahalanobis ? Metric::Euclidean : Metric::Mahalanobis;
            break;
    }
}

void expectSame(const CandidateSet& expected, const CandidateSet& found) {
    EXPECT_EQ(found.pointsAboveThreshold, expected.pointsAboveThreshold);
    EXPECT_EQ(found.candidateOfVoxel, expected.candidateOfVoxel);
    ASSERT_EQ(found.candidates.size(), expected.candidates.size());
    for (std::size_t i = 0; i < expected.candidates.size(); ++i) {
        const Candidate& a = expected.candidates[i];
        const Candidate& b = found.candidates[i];
        ASSERT_EQ(b.id, a.id);
        ASSERT_EQ(b.voxels, a.voxels);
        ASSERT_EQ(b.centroid_reference, a.centroid_reference);
        ASSERT_EQ(b.centroid_map, a.centroid_map);
        ASSERT_EQ(b.size_m, a.size_m);
        ASSERT_EQ(b.lengthDirection_rad, a.lengthDirection_rad);
        ASSERT_EQ(b.heightAboveFloor_m, a.heightAboveFloor_m);
        ASSERT_EQ(b.discrepancyMax, a.discrepancyMax);
        ASSERT_EQ(b.discrepancyMean, a.discrepancyMean);
        ASSERT_EQ(b.discrepancySum, a.discrepancySum);
    }
}

class LiveCandidatesOn : public testing::TestWithParam<Places> {};

TEST_P(LiveCandidatesOn, AreThoseFoundFromScratchHoweverTheSettingsAreMoved) {
    for (const std::size_t voxels : {1u, 30u, 400u, 1500u}) {
        Dice dice(voxels + static_cast<std::size_t>(GetParam()));
        const auto field = fieldOf(GetParam(), voxels, dice);
        LiveCandidates live(field, 0.02, 0.1, someTransform());
        CandidateSettings settings;
        for (int i = 0; i < 400; ++i) {
            move(settings, dice);
            SCOPED_TRACE(testing::Message() << voxels << " voxels, move " << i << ": threshold " << settings.threshold
                                            << ", cutoff " << settings.clusterCutoff_m);
            Progress progress;
            expectSame(findCandidates(*field, settings, 0.02, 0.1, someTransform(), progress),
                       *live.find(settings, progress));
            if (HasFatalFailure()) return;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Fields, LiveCandidatesOn, testing::Values(Places::Clumps, Places::Lattice, Places::Surface),
                         [](const testing::TestParamInfo<Places>& field) {
                             return field.param == Places::Clumps    ? "Clumps"
                                    : field.param == Places::Lattice ? "Lattice"
                                                                     : "Surface";
                         });

TEST(LiveCandidates, AreTheSameWithOneThreadAndWithTwo) {
    Dice dice(5);
    const auto field = fieldOf(Places::Surface, 6000, dice);
    CandidateSettings settings;
    std::vector<std::shared_ptr<const CandidateSet>> found;
    for (const std::size_t threads : {1u, 2u}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        LiveCandidates live(field, 0.02, 0.1, someTransform());
        for (const double threshold : {2.0, 1.0, 1.1, 0.3}) {
            Progress progress;
            settings.threshold = threshold;
            found.push_back(live.find(settings, progress));
        }
    }
    for (std::size_t i = 0; i < 4; ++i)
        expectSame(*found[i], *found[i + 4]);
}

TEST(LiveCandidates, ComeBackAfterACancelAndAfterSettingsThatAreRefused) {
    Dice dice(6);
    const auto field = fieldOf(Places::Clumps, 500, dice);
    LiveCandidates live(field, 0.02, 0.1, someTransform());
    CandidateSettings settings;
    for (const double threshold : {2.0, 1.5, 1.0}) {
        settings.threshold = threshold;
        Progress cancelled;
        cancelled.cancel();
        EXPECT_THROW(live.find(settings, cancelled), Cancelled);
        CandidateSettings refused = settings;
        refused.threshold = -1.0;
        Progress progress;
        EXPECT_THROW(live.find(refused, progress), Error);
        refused = settings;
        refused.clusterCutoff_m = std::nan("");
        EXPECT_THROW(live.find(refused, progress), Error);
        expectSame(findCandidates(*field, settings, 0.02, 0.1, someTransform(), progress),
                   *live.find(settings, progress));
    }
}

}  // namespace
}  // namespace fodscope
