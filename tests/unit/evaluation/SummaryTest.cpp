// SPDX-License-Identifier: MIT
#include "core/evaluation/Summary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/evaluation/EvaluationReport.h"

namespace fodscope {
namespace {

using nlohmann::json;
using testing::HasSubstr;

EvaluatedTrial trial(const std::string& name, std::vector<EvaluatedFod> fods, std::optional<TrialCounts> counts,
                     double cost) {
    EvaluatedTrial result;
    result.name = name;
    result.fods = std::move(fods);
    result.counts = counts;
    result.cost = cost;
    if (!counts) result.failure = "the map does not fit the reference";
    return result;
}

EvaluatedFod fod(const std::string& type, std::optional<double> distance_m, bool observed = true) {
    EvaluatedFod result{type, observed, distance_m, std::nullopt, std::nullopt};
    if (distance_m) result.nearest = "C-001";
    return result;
}

/// Two trials that went well, one without candidates, one that failed.
Evaluation example() {
    Evaluation evaluation;
    evaluation.trials = {trial("a", {fod("drill", 0.15), fod("level", 0.30)}, TrialCounts{4, 2, 1, 100}, 0.325),
                         trial("b", {fod("drill", 0.60, false)}, TrialCounts{2, 1, 2, 40}, 0.65),
                         trial("c", {fod("hammer", {})}, TrialCounts{0, 0, 0, 10}, 7.5),
                         trial("d", {fod("drill", {})}, std::nullopt, 7.5)};
    evaluation.nominalMaps = {"train_00"};
    return evaluation;
}

TEST(Summary, DividesByOneLessThanTheCount) {
    const MeanAndDeviation result = meanAndDeviation(std::vector<double>{2, 4, 4, 4, 5, 5, 7, 9});
    EXPECT_DOUBLE_EQ(5.0, *result.mean);
    EXPECT_NEAR(2.138089935299395, *result.deviation, 1e-12);
    EXPECT_FALSE(meanAndDeviation(std::vector<double>{3}).deviation.has_value());
    EXPECT_DOUBLE_EQ(3.0, *meanAndDeviation(std::vector<double>{3}).mean);
    EXPECT_FALSE(meanAndDeviation(std::vector<double>{}).mean.has_value());
}

TEST(Summary, CountsCandidatesOverTheTrialsThatDidNotFail) {
    const EvaluationSummary summary = summarize(example().trials);
    EXPECT_EQ(6u, summary.totalCandidates);
    EXPECT_EQ(3u, summary.unassociatedPoints.count);
    EXPECT_DOUBLE_EQ(50.0, *summary.unassociatedPoints.mean);
    EXPECT_NEAR(45.825756949558400, *summary.unassociatedPoints.deviation, 1e-12);
    EXPECT_DOUBLE_EQ(1.0, *summary.unassociatedCandidates.mean);
    EXPECT_DOUBLE_EQ(1.0, *summary.falseCandidates.mean);
    EXPECT_EQ((std::vector<std::string>{"d"}), summary.failedTrials);
}

TEST(Summary, ChargesFodWithoutCandidatesWhetherOrNotTheTrialFailed) {
    const EvaluationSummary summary = summarize(example().trials);
    EXPECT_EQ(2u, summary.chargedFods);
    EXPECT_NEAR((0.15 + 0.30 + 0.60 + 7.5 + 7.5) / 5, *summary.distanceError_m.mean, 1e-12);
    EXPECT_NEAR((0.325 + 0.65 + 7.5 + 7.5) / 4, *summary.meanCost, 1e-12);
}

TEST(Summary, CountsTheFodOfFailedTrialsAsMissed) {
    const EvaluationSummary summary = summarize(example().trials);
    EXPECT_EQ(5u, summary.recall.fods);
    EXPECT_DOUBLE_EQ(0.2, *summary.recall.at15cm());
    EXPECT_DOUBLE_EQ(0.4, *summary.recall.at30cm());
    EXPECT_DOUBLE_EQ(0.5, *summary.recallObserved.at30cm());
    ASSERT_EQ(3u, summary.recallByType.size());
    EXPECT_EQ("drill", summary.recallByType[0].type);
    EXPECT_DOUBLE_EQ(1.0 / 3.0, *summary.recallByType[0].recall.at30cm());
}

TEST(Summary, HasNoRecallWithoutFod) {
    EXPECT_FALSE(summarize({}).recall.at30cm().has_value());
    EXPECT_FALSE(summarize({}).meanCost.has_value());
}

TEST(Summary, PoolsThePhotosOfAllTrials) {
    Evaluation evaluation = example();
    evaluation.trials[0].photos = PhotoCounts{4, 3, 0, 10.5, {1, 1}};
    evaluation.trials[0].fods[0].photographed = true;
    evaluation.trials[0].fods[1].photographed = true;
    evaluation.trials[1].photos = PhotoCounts{1, 0, 1, 2.0, {0}};
    const PhotoSummary photos = *summarize(evaluation.trials).photos;
    EXPECT_DOUBLE_EQ(0.6, *photos.precision());
    EXPECT_DOUBLE_EQ(0.4, *photos.recall());
    EXPECT_DOUBLE_EQ(1.0, *photos.photosPerFod());
    EXPECT_DOUBLE_EQ(12.5, photos.drive_m);
    EXPECT_EQ(1u, photos.candidatesWithoutPhoto);
    EXPECT_FALSE(summarize(example().trials).photos.has_value());
}

TEST(EvaluationJson, HoldsWhatTheFileContractSays) {
    const json root = json::parse(evaluationJson(example(), {"ref.ply", "abc", 7}));
    ASSERT_EQ(4u, root["trials"].size());
    const json& a = root["trials"][0];
    EXPECT_EQ("a", a["name"]);
    EXPECT_EQ(json({{"type", "drill"}, {"observed", true}, {"distance_m", 0.15}, {"nearest", "C-001"}}), a["fods"][0]);
    EXPECT_EQ(4, a["candidates"]);
    EXPECT_EQ(2, a["unassociated_candidates"]);
    EXPECT_EQ(100, a["unassociated_points"]);
    EXPECT_EQ(0.325, a["cost"]);
    EXPECT_TRUE(root["trials"][2]["fods"][0]["distance_m"].is_null());
    EXPECT_TRUE(root["trials"][2]["fods"][0]["nearest"].is_null());
    const json& summary = root["summary"];
    EXPECT_EQ(6, summary["total_candidates"]);
    EXPECT_EQ(50.0, summary["unassociated_points_per_trial"]["mean"]);
    EXPECT_NEAR(45.825757, summary["unassociated_points_per_trial"]["std"].get<double>(), 1e-6);
    EXPECT_EQ(1.0, summary["unassociated_candidates_per_trial"]["mean"]);
    EXPECT_EQ(1.0, summary["false_candidates_per_trial"]["mean"]);
    EXPECT_NEAR(3.21, summary["distance_error_m"]["mean"].get<double>(), 1e-9);
    EXPECT_EQ(0.2, summary["recall"]["0.15"]);
    EXPECT_EQ(0.4, summary["recall"]["0.30"]);
    EXPECT_EQ(0.5, summary["recall_observed"]["0.30"]);
    EXPECT_EQ(0.333333, summary["recall_by_type"]["drill"]["0.30"]);
    EXPECT_NEAR(3.99375, summary["mean_cost"].get<double>(), 1e-6);
    EXPECT_FALSE(summary.contains("photos"));
    EXPECT_EQ(json({"train_00"}), root["nominal_maps"]);
}

TEST(EvaluationJson, TellsAFailedTrialByNameAndLeavesItsCountsUnknown) {
    const json root = json::parse(evaluationJson(example(), {"ref.ply", "abc", 7}));
    const json& failed = root["trials"][3];
    EXPECT_EQ("the map does not fit the reference", failed["failure"]);
    for (const char* key : {"candidates", "unassociated_candidates", "unassociated_points", "false_candidates"})
        EXPECT_TRUE(failed[key].is_null()) << key;
    EXPECT_EQ(json({"d"}), root["summary"]["failed_trials"]);
    EXPECT_THAT(root["how_counted"].dump(), HasSubstr("Failed to register: d."));
}

TEST(EvaluationText, ShowsTheTablesAndHowTheyWereCounted) {
    const std::string text = evaluationText(example());
    EXPECT_THAT(text, HasSubstr("50.0 ± 45.8"));
    EXPECT_THAT(text, HasSubstr("d failed: the map does not fit the reference"));
    EXPECT_THAT(text, HasSubstr("How it was counted"));
    EXPECT_THAT(text, HasSubstr("(train_00)"));
    EXPECT_THAT(text, testing::ContainsRegex("drill +3 +1 +2 +0.33 +0.33"));
    EXPECT_THAT(text, testing::ContainsRegex("total +5 +2 +3 +0.40 +0.20"));
}

}  // namespace
}  // namespace fodscope
