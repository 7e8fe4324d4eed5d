// SPDX-License-Identifier: MIT
#include "core/inspection/DetectionPipeline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "core/common/Error.h"
#include "core/reference/MeanReference.h"
#include "tests/unit/registration/SyntheticRoom.h"

namespace fodscope {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

PointCloud nominalMap(std::uint64_t seed) {
    PointCloud map;
    map.points = test::sample(test::roomPanels(), 900.0, 0.003, seed);
    return map;
}

/// The room's mean reference from three nominal maps.
std::shared_ptr<const ReferenceMap> roomReferenceMap() {
    static const auto reference = [] {
        const std::vector<PointCloud> maps{nominalMap(11), nominalMap(12), nominalMap(13)};
        std::vector<AlignedNominalMap> aligned;
        for (const PointCloud& map : maps)
            aligned.push_back({&map, Transform::Identity()});
        Progress progress;
        return std::make_shared<const ReferenceMap>(meanReference(aligned, {}, progress));
    }();
    return reference;
}

/// The room with a box of 20 cm on its floor and one of 12 cm elsewhere.
std::shared_ptr<const PointCloud> mapWithObjects() {
    PointCloud map = nominalMap(21);
    for (const auto& [low, high] : {std::pair(Eigen::Vector3d(2.0, 1.2, 0), Eigen::Vector3d(2.2, 1.4, 0.2)),
                                    std::pair(Eigen::Vector3d(0.6, 1.9, 0), Eigen::Vector3d(0.72, 2.02, 0.12))}) {
        const auto points = test::sample(test::boxPanels(low, high), 3000.0, 0.002, 31);
        map.points.insert(map.points.end(), points.begin(), points.end());
    }
    for (Eigen::Vector3d& point : map.points)
        point = test::motion(1.0, {0.03, -0.02, 0.0}) * point;
    return std::make_shared<const PointCloud>(std::move(map));
}

Parameters paper() {
    return presetParameters("paper-physical");
}

DetectionPipeline readyPipeline() {
    DetectionPipeline pipeline;
    pipeline.setReference(roomReferenceMap());
    pipeline.setMap(mapWithObjects());
    return pipeline;
}

std::vector<std::string> stagesOf(const DetectionResult& result) {
    std::vector<std::string> stages;
    for (const auto& [stage, seconds] : result.stageSeconds)
        stages.push_back(stage);
    return stages;
}

void expectSame(const CandidateSet& a, const CandidateSet& b) {
    EXPECT_EQ(a.pointsAboveThreshold, b.pointsAboveThreshold);
    EXPECT_EQ(a.candidateOfVoxel, b.candidateOfVoxel);
    ASSERT_EQ(a.candidates.size(), b.candidates.size());
    for (std::size_t i = 0; i < a.candidates.size(); ++i) {
        EXPECT_EQ(a.candidates[i].id, b.candidates[i].id);
        EXPECT_EQ(a.candidates[i].centroid_reference, b.candidates[i].centroid_reference);
        EXPECT_EQ(a.candidates[i].discrepancySum, b.candidates[i].discrepancySum);
    }
}

TEST(DetectionPipeline, ObjectsThatTheReferenceLacksBecomeCandidates) {
    DetectionPipeline pipeline = readyPipeline();
    Progress progress;
    const DetectionResult& result = pipeline.run(paper(), progress);
    EXPECT_EQ(result.registration.quality, RegistrationQuality::Good);
    ASSERT_TRUE(result.candidates);
    for (const Eigen::Vector3d& object : {Eigen::Vector3d(2.1, 1.3, 0.1), Eigen::Vector3d(0.66, 1.96, 0.06)}) {
        double nearest_m = 1e9;
        for (const Candidate& candidate : result.candidates->candidates) {
            nearest_m = std::min(nearest_m, (candidate.centroid_reference - object).norm());
        }
        EXPECT_LT(nearest_m, 0.1);
    }
    EXPECT_GT(result.coverage->observedShare, 0.95);
    EXPECT_NEAR(result.floorHeight_m, 0.0, 0.02);
    EXPECT_THAT(stagesOf(result), ElementsAre("candidates", "coverage", "denoise", "discrepancy", "registration"));
}

TEST(DetectionPipeline, ANewThresholdRunsOnlyTheLastStageAndGivesWhatARunFromScratchGives) {
    DetectionPipeline pipeline = readyPipeline();
    Progress progress;
    pipeline.run(paper(), progress);
    Parameters stricter = paper();
    stricter.candidates.threshold = 4.0;
    const DetectionResult& again = pipeline.run(stricter, progress);
    EXPECT_THAT(stagesOf(again), ElementsAre("candidates"));

    DetectionPipeline fresh = readyPipeline();
    expectSame(*again.candidates, *fresh.run(stricter, progress).candidates);
}

TEST(DetectionPipeline, NothingRunsWhenNothingChanged) {
    DetectionPipeline pipeline = readyPipeline();
    Progress progress;
    pipeline.run(paper(), progress);
    EXPECT_THAT(stagesOf(pipeline.run(paper(), progress)), IsEmpty());
}

TEST(DetectionPipeline, EachSettingRunsItsStageAndThoseThatRestOnIt) {
    DetectionPipeline pipeline = readyPipeline();
    Progress progress;
    pipeline.run(paper(), progress);
    Parameters parameters = paper();
    parameters.coverage.observedWithin_m = 0.2;
    EXPECT_THAT(stagesOf(pipeline.run(parameters, progress)), ElementsAre("coverage"));
    parameters.discrepancy.cropHeight_m = 0.5;
    EXPECT_THAT(stagesOf(pipeline.run(parameters, progress)), ElementsAre("candidates", "coverage", "discrepancy"));
    parameters.denoise.standardDeviations = 3.0;
    EXPECT_THAT(stagesOf(pipeline.run(parameters, progress)),
                ElementsAre("candidates", "coverage", "denoise", "discrepancy", "registration"));
    parameters.waypoints.minimumDistance_m = 0.4;
    EXPECT_THAT(stagesOf(pipeline.run(parameters, progress)), IsEmpty());
}

TEST(DetectionPipeline, TheLocalStatisticalTestIsMadeOnlyForItsMetric) {
    DetectionPipeline pipeline = readyPipeline();
    Progress progress;
    const auto before = pipeline.run(paper(), progress).field;
    EXPECT_FALSE(before->has(Metric::ChiSquare));
    Parameters parameters = paper();
    parameters.candidates = usualCandidateSettings(Metric::ChiSquare, parameters);
    const DetectionResult& result = pipeline.run(parameters, progress);
    EXPECT_THAT(stagesOf(result), ElementsAre("candidates", "chi_square"));
    EXPECT_TRUE(result.field->has(Metric::ChiSquare));
    EXPECT_GT(result.candidates->pointsAboveThreshold, 0U);
    DetectionPipeline fresh = readyPipeline();
    expectSame(*result.candidates, *fresh.run(parameters, progress).candidates);

    parameters.candidates.threshold = 6.0;
    EXPECT_THAT(stagesOf(pipeline.run(parameters, progress)), ElementsAre("candidates"));
    parameters.chiSquare.neighbours = 25;
    EXPECT_THAT(stagesOf(pipeline.run(parameters, progress)), ElementsAre("candidates", "chi_square"));
    EXPECT_THAT(stagesOf(pipeline.run(paper(), progress)), ElementsAre("candidates"));
    EXPECT_EQ(pipeline.run(paper(), progress).field, before);
}

TEST(DetectionPipeline, AGivenTransformReplacesTheRegistration) {
    DetectionPipeline pipeline = readyPipeline();
    Progress progress;
    pipeline.run(paper(), progress);
    const Transform given = test::motion(1.0, {0.03, -0.02, 0.0}).inverse();
    pipeline.setGivenTransform(given);
    const DetectionResult& result = pipeline.run(paper(), progress);
    EXPECT_EQ(result.registration.quality, RegistrationQuality::Given);
    EXPECT_EQ(result.registration.T_reference_from_map.matrix(), given.matrix());
    EXPECT_EQ(result.stageSeconds.count("denoise"), 0U);
    EXPECT_EQ(result.stageSeconds.count("discrepancy"), 1U);
}

TEST(DetectionPipeline, NoCandidatesAreClaimedFromABadAlignment) {
    DetectionPipeline pipeline = readyPipeline();
    Progress progress;
    Parameters parameters = paper();
    parameters.registration.minimumOverlap = 1.0;
    const DetectionResult& bad = pipeline.run(parameters, progress);
    EXPECT_EQ(bad.registration.quality, RegistrationQuality::Bad);
    EXPECT_FALSE(bad.field);
    EXPECT_FALSE(bad.candidates);
    EXPECT_FALSE(bad.coverage);
    EXPECT_TRUE(pipeline.run(paper(), progress).candidates);
}

TEST(DetectionPipeline, ACancelledRunKeepsTheLastGoodResult) {
    DetectionPipeline pipeline = readyPipeline();
    Progress progress;
    const DetectionResult good = pipeline.run(paper(), progress);
    Parameters other = paper();
    other.discrepancy.smoothing.neighbours = 20;
    Progress cancelled;
    cancelled.cancel();
    EXPECT_THROW(pipeline.run(other, cancelled), Cancelled);
    Progress further;
    const DetectionResult& again = pipeline.run(paper(), further);
    expectSame(*again.candidates, *good.candidates);
    EXPECT_THAT(stagesOf(again), IsEmpty());
}

TEST(DetectionPipeline, AStageThatIsCancelledRunsWholeTheNextTime) {
    DetectionPipeline fresh = readyPipeline();
    Progress progress;
    const DetectionResult expected = fresh.run(paper(), progress);

    // Stops at the first report of one stage after another until a run gets through.
    std::set<std::string> stopped;
    DetectionPipeline pipeline = readyPipeline();
    for (;;) {
        Progress* running = nullptr;
        Progress stopping([&](const std::string& stage, double) {
            if (stopped.insert(stage).second) running->cancel();
        });
        running = &stopping;
        try {
            expectSame(*pipeline.run(paper(), stopping).candidates, *expected.candidates);
            break;
        } catch (const Cancelled&) {
            continue;
        }
    }
    EXPECT_GE(stopped.size(), 3U);
}

TEST(DetectionPipeline, WhatIsMissingIsSaid) {
    DetectionPipeline pipeline;
    Progress progress;
    EXPECT_THROW(pipeline.run(paper(), progress), Error);
    auto bare = std::make_shared<ReferenceMap>();
    bare->points = roomReferenceMap()->points;
    pipeline.setReference(bare);
    EXPECT_THROW(pipeline.run(paper(), progress), Error);
    pipeline.setMap(mapWithObjects());
    try {
        pipeline.run(paper(), progress);
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("no covariances"));
    }
}

TEST(DetectionPipeline, ASinglePointIsAnErrorOrABadAlignmentNeverACrash) {
    DetectionPipeline pipeline;
    pipeline.setReference(roomReferenceMap());
    PointCloud single;
    single.points = {{1.0, 1.0, 0.0}};
    pipeline.setMap(std::make_shared<PointCloud>(single));
    Progress progress;
    try {
        EXPECT_EQ(pipeline.run(paper(), progress).registration.quality, RegistrationQuality::Bad);
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("map: "));
    }
}

TEST(DetectionPipeline, SettingsOutOfRangeAreListedAtOnceBeforeAnythingRuns) {
    DetectionPipeline pipeline = readyPipeline();
    Parameters parameters = paper();
    parameters.denoise.neighbours = -3;
    parameters.registration.mapVoxelSize_m = 0.0;
    parameters.discrepancy.voxelSize_m = std::nan("");
    parameters.chiSquare.pValue = 2.0;
    parameters.candidates.threshold = -HUGE_VAL;
    parameters.coverage.observedWithin_m = 0.0;
    Progress progress([](const std::string& stage, double) { ADD_FAILURE() << stage; });
    try {
        pipeline.run(parameters, progress);
        FAIL();
    } catch (const Error& error) {
        for (const char* key : {"denoise.neighbours", "registration.map_voxel_size_m", "discrepancy.voxel_size_m",
                                "chi_square.p_value", "candidates.threshold", "coverage.observed_within_m"})
            EXPECT_THAT(error.what(), HasSubstr(key));
    }
}

TEST(DetectionPipeline, AGivenMapGivesTheSameAndIsNeededAnewForOtherOutlierRemoval) {
    Progress progress;
    DetectionPipeline pipeline = readyPipeline();
    const DetectionResult expected = pipeline.run(paper(), progress);
    pipeline = readyPipeline();
    pipeline.giveMap(*mapWithObjects());
    const DetectionResult result = pipeline.run(paper(), progress);
    EXPECT_EQ(result.denoisedMap->points, expected.denoisedMap->points);
    EXPECT_EQ(result.denoisedMap->colours, expected.denoisedMap->colours);
    expectSame(*result.candidates, *expected.candidates);
    Parameters parameters = paper();
    parameters.discrepancy.smoothing.neighbours = 10;
    EXPECT_NE(pipeline.run(parameters, progress).field, result.field);
    pipeline.setReference(roomReferenceMap());
    EXPECT_NO_THROW(pipeline.run(parameters, progress));
    parameters.denoise.neighbours = 20;
    EXPECT_THROW(pipeline.run(parameters, progress), Error);
    pipeline.giveMap(*mapWithObjects());
    EXPECT_NO_THROW(pipeline.run(parameters, progress));
}

TEST(DetectionPipeline, AResultKeepsAGivenMapWhoseOutliersStayed) {
    Progress progress;
    DetectionPipeline pipeline = readyPipeline();
    pipeline.giveMap(*mapWithObjects());
    Parameters parameters = paper();
    parameters.denoise.enabled = false;
    const DetectionResult whole = pipeline.run(parameters, progress);
    EXPECT_LT(pipeline.run(paper(), progress).denoisedMap->size(), whole.denoisedMap->size());
    EXPECT_EQ(whole.denoisedMap->points, mapWithObjects()->points);
}

TEST(DetectionPipeline, MapsAndReferencesThatAreNotFiniteAreErrors) {
    Progress progress;
    auto map = std::make_shared<PointCloud>(*mapWithObjects());
    map->points[100].x() = std::nan("");
    DetectionPipeline pipeline = readyPipeline();
    pipeline.setMap(map);
    EXPECT_THROW(pipeline.run(paper(), progress), Error);
    auto reference = std::make_shared<ReferenceMap>(*roomReferenceMap());
    reference->points[100].x() = HUGE_VAL;
    pipeline = readyPipeline();
    pipeline.setReference(reference);
    EXPECT_THROW(pipeline.run(paper(), progress), Error);
}

TEST(DetectionPipeline, CoincidentPointsAreAnErrorOrABadAlignmentNeverACrash) {
    DetectionPipeline pipeline = readyPipeline();
    PointCloud map;
    map.points.assign(1000, Eigen::Vector3d(1.0, 1.0, 0.5));
    pipeline.setMap(std::make_shared<PointCloud>(map));
    Progress progress;
    try {
        EXPECT_EQ(pipeline.run(paper(), progress).registration.quality, RegistrationQuality::Bad);
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("map: "));
    }
}

}  // namespace
}  // namespace fodscope
