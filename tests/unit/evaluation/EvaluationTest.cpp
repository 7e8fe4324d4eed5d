// SPDX-License-Identifier: MIT
#include "core/evaluation/Evaluation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/cloud/PointCloudIo.h"
#include "core/common/Error.h"
#include "core/common/Files.h"
#include "core/reference/MeanReference.h"
#include "tests/unit/registration/SyntheticRoom.h"

namespace fodscope {
namespace {

using testing::HasSubstr;

Candidate candidateAt(const std::string& id, const Eigen::Vector3d& centroid_map, std::vector<std::uint32_t> voxels) {
    Candidate candidate;
    candidate.id = id;
    candidate.centroid_map = centroid_map;
    candidate.voxels = std::move(voxels);
    return candidate;
}

DetectionResult detectionOf(std::vector<Candidate> candidates, std::size_t pointsAboveThreshold) {
    CandidateSet set;
    set.candidates = std::move(candidates);
    set.pointsAboveThreshold = pointsAboveThreshold;
    DetectionResult detection;
    detection.registration.quality = RegistrationQuality::Good;
    detection.candidates = std::make_shared<const CandidateSet>(std::move(set));
    return detection;
}

Trial trialWith(std::vector<GroundTruthFod> fods) {
    Trial trial;
    trial.name = "a";
    trial.fods = std::move(fods);
    return trial;
}

TEST(EvaluateDetection, CountsThePointsOutsideAssociatedCandidates) {
    // 9 points above the threshold: 3 + 2 in the candidates, 4 in clusters that were too small.
    const DetectionResult detection =
        detectionOf({candidateAt("C-001", {2, 0, 0}, {0, 1, 2}), candidateAt("C-002", {0.2, 0, 0}, {3, 4})}, 9);
    const EvaluatedTrial result = evaluateDetection(trialWith({{"drill", true, {0, 0, 0}}}), detection, 0.05);
    EXPECT_EQ("C-002", result.fods[0].nearest);
    EXPECT_DOUBLE_EQ(0.2, *result.fods[0].distance_m);
    EXPECT_EQ(2u, result.counts->candidates);
    EXPECT_EQ(1u, result.counts->unassociatedCandidates);
    EXPECT_EQ(1u, result.counts->falseCandidates);
    EXPECT_EQ(7u, result.counts->unassociatedPoints);
    EXPECT_DOUBLE_EQ(0.25, result.cost);
    EXPECT_TRUE(result.failure.empty());
}

TEST(EvaluateDetection, CountsEveryPointWhereThereIsNoCandidate) {
    const EvaluatedTrial result = evaluateDetection(trialWith({{"drill", true, {0, 0, 0}}}), detectionOf({}, 5), 0.05);
    EXPECT_EQ(5u, result.counts->unassociatedPoints);
    EXPECT_FALSE(result.fods[0].distance_m.has_value());
    EXPECT_DOUBLE_EQ(7.5, result.cost);
}

TEST(EvaluateDetection, LeavesTheCountsOfAFailedTrialUnknown) {
    DetectionResult detection;
    detection.registration.summary = "the map does not fit";
    const EvaluatedTrial result = evaluateDetection(trialWith({{"drill", true, {0, 0, 0}}}), detection, 0.05);
    EXPECT_FALSE(result.counts.has_value());
    EXPECT_EQ("the map does not fit", result.failure);
    EXPECT_FALSE(result.fods[0].distance_m.has_value());
    EXPECT_DOUBLE_EQ(7.5, result.cost);
}

/// A synthetic room as a folder of trials.
class EvaluateTrials : public testing::Test {
  protected:
    EvaluateTrials() {
        folder_ = std::filesystem::path(testing::TempDir()) / "fodscope_evaluation" /
                  testing::UnitTest::GetInstance()->current_test_info()->name();
        std::filesystem::remove_all(folder_);
        makeFolder(folder_);
    }
    ~EvaluateTrials() override { std::filesystem::remove_all(folder_); }

    static PointCloud room(std::uint64_t seed) {
        PointCloud map;
        map.points = test::sample(test::roomPanels(), 900.0, 0.003, seed);
        return map;
    }

    static std::shared_ptr<const ReferenceMap> reference() {
        const std::vector<PointCloud> maps{room(11), room(12), room(13)};
        std::vector<AlignedNominalMap> aligned;
        for (const PointCloud& map : maps)
            aligned.push_back({&map, Transform::Identity()});
        Progress progress;
        return std::make_shared<const ReferenceMap>(meanReference(aligned, {}, progress));
    }

    Trial write(const std::string& name, const PointCloud& map, std::vector<GroundTruthFod> fods) {
        Trial trial = trialWith(std::move(fods));
        trial.name = name;
        trial.map = folder_ / (name + ".pcd");
        writePointCloud(trial.map, map, PcdEncoding::Binary);
        return trial;
    }

    Trial withBox(const std::string& name) {
        PointCloud map = room(21);
        const auto box = test::sample(test::boxPanels({2.0, 1.2, 0}, {2.2, 1.4, 0.2}), 3000.0, 0.002, 31);
        map.points.insert(map.points.end(), box.begin(), box.end());
        return write(name, map, {{"box", true, {2.1, 1.3, 0.1}}});
    }

    static EvaluationSettings settings() {
        EvaluationSettings settings;
        settings.parameters = presetParameters("paper-physical");
        return settings;
    }

    std::filesystem::path folder_;
};

TEST_F(EvaluateTrials, FindsWhatWasPutThereAndLeavesNominalMapsOut) {
    const std::vector<Trial> trials = {withBox("a"), write("n", room(22), {})};
    Progress progress;
    const Evaluation evaluation = evaluateTrials(reference(), trials, settings(), {}, progress);
    ASSERT_EQ(1u, evaluation.trials.size());
    ASSERT_TRUE(evaluation.trials[0].fods[0].distance_m.has_value());
    EXPECT_LT(*evaluation.trials[0].fods[0].distance_m, 0.1);
    EXPECT_EQ((std::vector<std::string>{"n"}), evaluation.nominalMaps);
}

TEST_F(EvaluateTrials, TellsATrialThatCannotBeAlignedAndGoesOn) {
    PointCloud line;
    for (int i = 0; i < 5000; ++i)
        line.points.emplace_back(40.0 + 0.02 * i, std::sin(0.1 * i) * 30.0, std::cos(0.37 * i) * 30.0);
    const std::vector<Trial> trials = {write("a", line, {{"box", true, {0, 0, 0}}}), withBox("b")};
    Progress progress;
    const Evaluation evaluation = evaluateTrials(reference(), trials, settings(), {}, progress);
    ASSERT_EQ(2u, evaluation.trials.size());
    EXPECT_FALSE(evaluation.trials[0].counts.has_value());
    EXPECT_FALSE(evaluation.trials[0].failure.empty());
    EXPECT_TRUE(evaluation.trials[1].counts.has_value());
}

TEST_F(EvaluateTrials, StoredTransformsReplaceTheRegistration) {
    std::vector<Trial> trials = {withBox("a")};
    trials[0].T_cad_from_map = Transform::Identity();
    EvaluationSettings stored = settings();
    stored.placement = TrialPlacement::Stored;
    Progress progress;
    const Evaluation evaluation = evaluateTrials(reference(), trials, stored, {}, progress);
    EXPECT_EQ(RegistrationQuality::Given, evaluation.trials[0].registration.quality);
    EXPECT_DOUBLE_EQ(0.0, *evaluation.trials[0].cornerError_m);

    trials[0].T_cad_from_map.reset();
    try {
        evaluateTrials(reference(), trials, stored, {}, progress);
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("no T_cad_from_map is stored for a"));
    }
}

TEST_F(EvaluateTrials, TakesPhotosOfWhatWasDetected) {
    const std::vector<Trial> trials = {withBox("a")};
    const PhotoTaker takePhotos = [](const Trial& trial, const DetectionResult& detection, Progress&) {
        EXPECT_FALSE(detection.candidates->candidates.empty());
        return PhotoCounts{2, 1, 0, 3.5, std::vector<std::uint8_t>(trial.fods.size(), 1)};
    };
    Progress progress;
    const Evaluation evaluation = evaluateTrials(reference(), trials, settings(), takePhotos, progress);
    EXPECT_EQ(true, evaluation.trials[0].fods[0].photographed);
    EXPECT_EQ(2u, evaluation.trials[0].photos->photos);
}

TEST_F(EvaluateTrials, SaysWhenThereIsNothingToFind) {
    const std::vector<Trial> trials = {write("n", room(22), {})};
    Progress progress;
    EXPECT_THROW(evaluateTrials(reference(), trials, settings(), {}, progress), Error);
}

TEST_F(EvaluateTrials, NamesTheMapThatCannotBeUsed) {
    std::vector<Trial> trials = {withBox("a")};
    writeFile(trials[0].map, "damaged");
    Progress progress;
    try {
        evaluateTrials(reference(), trials, settings(), {}, progress);
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("a.pcd"));
    }
}

TEST_F(EvaluateTrials, StopsWhenAskedTo) {
    const std::vector<Trial> trials = {withBox("a"), withBox("b")};
    Progress* all = nullptr;
    Progress progress([&](const std::string& stage, double) {
        if (stage.starts_with("b ")) all->cancel();
    });
    all = &progress;
    EXPECT_THROW(evaluateTrials(reference(), trials, settings(), {}, progress), Cancelled);
}

}  // namespace
}  // namespace fodscope
