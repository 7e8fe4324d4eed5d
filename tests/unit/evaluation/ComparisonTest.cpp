// SPDX-License-Identifier: MIT
#include "core/evaluation/Comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/common/Error.h"
#include "core/common/Files.h"

namespace fodscope {
namespace {

using nlohmann::json;
using testing::HasSubstr;

RecordedTrial trial(const std::string& name, double points, double candidates, std::vector<RecordedFod> fods) {
    return {name, std::move(fods), points, candidates};
}

RecordedEvaluation evaluation(const std::string& file, std::vector<RecordedTrial> trials) {
    return {file, std::move(trials)};
}

std::string problemOf(const RecordedEvaluation& a, const RecordedEvaluation& b) {
    try {
        compareEvaluations(a, b);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Comparison, PairsTrialsAndFodAndTestsBothDirections) {
    // scipy: wilcoxon([-1, -2, -3], alternative="less") gives 0.125, "greater" 1.0.
    const auto a = evaluation("A.json", {trial("x", 10, 1, {{"drill", 0.1}}), trial("y", 20, 2, {{"level", 0.3}}),
                                         trial("z", 30, 3, {{"drill", {}}})});
    const auto b = evaluation("B.json", {trial("x", 11, 1, {{"drill", 0.1}}), trial("y", 22, 2, {{"level", 0.2}}),
                                         trial("z", 33, 3, {{"drill", 0.5}})});
    const Comparison comparison = compareEvaluations(a, b);
    ASSERT_EQ(3u, comparison.tests.size());
    EXPECT_EQ("unassociated_points", comparison.tests[0].quantity);
    EXPECT_DOUBLE_EQ(0.125, *comparison.tests[0].test.less);
    EXPECT_DOUBLE_EQ(1.0, *comparison.tests[0].test.greater);
    EXPECT_DOUBLE_EQ(20.0, *comparison.tests[0].meanA);
    EXPECT_DOUBLE_EQ(22.0, *comparison.tests[0].meanB);
    // The same everywhere: nothing can be tested.
    EXPECT_EQ(3u, comparison.tests[1].test.zeros);
    EXPECT_FALSE(comparison.tests[1].test.less.has_value());
    // One FOD without a candidate is charged 7.5 m.
    EXPECT_EQ("distance_error_m", comparison.tests[2].quantity);
    EXPECT_NEAR((0.1 + 0.3 + 7.5) / 3, *comparison.tests[2].meanA, 1e-12);
    EXPECT_EQ(3u, comparison.fods);
}

TEST(Comparison, LeavesTrialsThatFailedOutOfTheCounts) {
    auto a = evaluation("A.json", {trial("x", 1, 1, {{"drill", 0.1}}), trial("y", 2, 2, {{"drill", {}}})});
    const auto b = evaluation("B.json", {trial("x", 5, 4, {{"drill", 0.2}}), trial("y", 2, 2, {{"drill", 0.2}})});
    a.trials[1].unassociatedPoints.reset();
    a.trials[1].unassociatedCandidates.reset();
    const Comparison comparison = compareEvaluations(a, b);
    EXPECT_EQ((std::vector<std::string>{"y"}), comparison.failedTrials);
    EXPECT_EQ(1u, comparison.tests[0].test.pairs);
    EXPECT_EQ(1u, comparison.tests[1].test.pairs);
    EXPECT_EQ(2u, comparison.tests[2].test.pairs);
    EXPECT_THAT(comparisonText(comparison), HasSubstr("no pair of counts: y."));
}

TEST(Comparison, RefusesOtherTrials) {
    const auto a = evaluation("A.json", {trial("x", 1, 1, {{"drill", 0.1}}), trial("y", 1, 1, {})});
    EXPECT_THAT(problemOf(a, evaluation("B.json", {trial("x", 1, 1, {{"drill", 0.1}}), trial("z", 1, 1, {})})),
                HasSubstr("B.json: does not evaluate the same trials as A.json (only there: y, only here: z)"));
    EXPECT_THAT(problemOf(a, evaluation("B.json", {trial("x", 1, 1, {{"level", 0.1}}), trial("y", 1, 1, {})})),
                HasSubstr("with other FOD (x)"));
    EXPECT_THAT(problemOf(evaluation("A.json", {}), evaluation("B.json", {})), HasSubstr("holds no trials"));
}

TEST(Comparison, WritesThePValuesWithTheirDirectionAndNumber) {
    const auto a = evaluation("A.json", {trial("x", 1, 1, {{"drill", 0.1}})});
    const auto b = evaluation("B.json", {trial("x", 5, 1, {{"drill", 0.2}})});
    const json root = json::parse(comparisonJson(compareEvaluations(a, b)));
    EXPECT_EQ(1, root["tests"]["unassociated_points"]["n"]);
    EXPECT_EQ(0.5, root["tests"]["unassociated_points"]["p_a_smaller_than_b"]);
    EXPECT_EQ(1.0, root["tests"]["unassociated_points"]["p_b_smaller_than_a"]);
    EXPECT_EQ("exact", root["tests"]["unassociated_points"]["method"]);
    EXPECT_TRUE(root["tests"]["unassociated_candidates"]["p_a_smaller_than_b"].is_null());
    EXPECT_EQ(1, root["tests"]["distance_error_m"]["n"]);
}

class ReadEvaluation : public testing::Test {
  protected:
    ReadEvaluation() : file_(std::filesystem::path(testing::TempDir()) / "fodscope_read_evaluation.json") {}
    ~ReadEvaluation() override { std::filesystem::remove(file_); }

    std::string problem(const std::string& text) {
        writeFile(file_, text);
        try {
            readEvaluation(file_);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

    std::filesystem::path file_;
};

TEST_F(ReadEvaluation, TakesWhatEvaluateWrites) {
    writeFile(file_, std::string(R"({"trials": [
        {"name": "b", "fods": [{"type": "drill", "distance_m": 0.5}], "unassociated_points": 3,
         "unassociated_candidates": 1},
        {"name": "a", "fods": [{"type": "drill", "distance_m": null}], "unassociated_points": null,
         "unassociated_candidates": null}]})"));
    const RecordedEvaluation evaluation = readEvaluation(file_);
    ASSERT_EQ(2u, evaluation.trials.size());
    EXPECT_EQ("a", evaluation.trials[0].name);
    EXPECT_FALSE(evaluation.trials[0].unassociatedPoints.has_value());
    EXPECT_FALSE(evaluation.trials[0].fods[0].distance_m.has_value());
    EXPECT_EQ(3.0, evaluation.trials[1].unassociatedPoints);
}

TEST_F(ReadEvaluation, NamesTheFieldThatIsWrong) {
    EXPECT_THAT(problem("{\"trials\": [{"), HasSubstr("no JSON object"));
    EXPECT_THAT(problem("{}"), HasSubstr("\"trials\" is missing"));
    EXPECT_THAT(problem(R"({"trials": {}})"), HasSubstr("\"trials\" is not a list"));
    EXPECT_THAT(problem(R"({"trials": [3]})"), HasSubstr("\"trials[0].name\" is missing"));
    EXPECT_THAT(problem(R"({"trials": [{"name": "a", "unassociated_points": "3"}]})"),
                HasSubstr("\"trials[0].unassociated_points\" is neither null nor a number"));
    EXPECT_THAT(problem(R"({"trials": [{"name": "a", "unassociated_points": 1, "unassociated_candidates": 1,
                            "fods": [{"type": "drill", "distance_m": -1}]}]})"),
                HasSubstr("\"trials[0].fods[0].distance_m\" is neither"));
    EXPECT_THAT(problem(R"({"trials": [
        {"name": "a", "fods": [], "unassociated_points": 1, "unassociated_candidates": 1},
        {"name": "a", "fods": [], "unassociated_points": 1, "unassociated_candidates": 1}]})"),
                HasSubstr("the trial a is there twice"));
}

}  // namespace
}  // namespace fodscope
