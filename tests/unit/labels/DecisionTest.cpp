// SPDX-License-Identifier: MIT
#include "core/labels/Decision.h"

#include <gtest/gtest.h>

namespace fodscope {
namespace {

LabelSet tools() {
    return parseLabelSet("{name: Tools, labels: [hammer, drill]}", "tools");
}

Decision says(const std::string& labeller, const std::string& photo, const std::vector<std::string>& labels) {
    Decision decision;
    decision.photoId = photo;
    decision.labeller = labeller;
    for (const std::string& label : labels) {
        decision.labels.push_back({label, std::nullopt});
    }
    return decision;
}

struct VerdictCase {
    const char* name;
    std::vector<PhotoSubject> photos;
    std::vector<Decision> decisions;
    Verdict verdict;
    std::vector<std::string> fodLabels;
};

class Verdicts : public testing::TestWithParam<VerdictCase> {};

TEST_P(Verdicts, FollowTheRule) {
    const VerdictCase& c = GetParam();
    const std::vector<std::string> ids{"C-001"};
    const auto verdicts = resolveVerdicts(ids, c.photos, c.decisions, tools());
    ASSERT_EQ(verdicts.size(), 1u);
    EXPECT_EQ(verdicts[0].candidateId, "C-001");
    EXPECT_EQ(toString(verdicts[0].verdict), toString(c.verdict));
    EXPECT_EQ(verdicts[0].fodLabels, c.fodLabels);
}

const std::vector<PhotoSubject> kOne{{"P-001", {"C-001"}}};
const std::vector<PhotoSubject> kTwo{{"P-001", {"C-001"}}, {"P-002", {"C-001", "C-002"}}};

INSTANTIATE_TEST_SUITE_P(
    Rule, Verdicts,
    testing::Values(
        VerdictCase{"NoPhoto", {}, {}, Verdict::NotPhotographed, {}},
        VerdictCase{"OnlyAnothersPhoto",
                    {{"P-001", {"C-002"}}},
                    {says("Anna", "P-001", {"hammer"})},
                    Verdict::NotPhotographed,
                    {}},
        VerdictCase{"NoDecision", kOne, {}, Verdict::Undecided, {}},
        VerdictCase{"Fod", kOne, {says("Anna", "P-001", {"hammer"})}, Verdict::Finding, {"hammer"}},
        VerdictCase{"TwoFodOnOnePhoto",
                    kOne,
                    {says("Anna", "P-001", {"hammer", "drill"})},
                    Verdict::Finding,
                    {"hammer", "drill"}},
        VerdictCase{"NoFod", kOne, {says("Anna", "P-001", {kNoFod})}, Verdict::NoFod, {}},
        VerdictCase{"NotSure", kOne, {says("Anna", "P-001", {kNotSure})}, Verdict::Open, {}},
        VerdictCase{"LastDecisionCounts",
                    kOne,
                    {says("Anna", "P-001", {"hammer"}), says("Anna", "P-001", {kNoFod})},
                    Verdict::NoFod,
                    {}},
        VerdictCase{
            "TakenBack", kOne, {says("Anna", "P-001", {"hammer"}), says("Anna", "P-001", {})}, Verdict::Undecided, {}},
        VerdictCase{"ReadersAgree",
                    kOne,
                    {says("Anna", "P-001", {"hammer"}), says("Ben", "P-001", {"hammer"})},
                    Verdict::Finding,
                    {"hammer"}},
        VerdictCase{"ReadersAgreeInAnotherOrder",
                    kOne,
                    {says("Anna", "P-001", {"hammer", "drill"}), says("Ben", "P-001", {"drill", "hammer"})},
                    Verdict::Finding,
                    {"hammer", "drill"}},
        VerdictCase{"ReadersDisagreeOnFod",
                    kOne,
                    {says("Anna", "P-001", {"hammer"}), says("Ben", "P-001", {kNoFod})},
                    Verdict::Open,
                    {"hammer"}},
        VerdictCase{"ReadersDisagreeOnTheKind",
                    kOne,
                    {says("Anna", "P-001", {"hammer"}), says("Ben", "P-001", {"drill"})},
                    Verdict::Open,
                    {"hammer", "drill"}},
        VerdictCase{"SecondReaderNotSure",
                    kOne,
                    {says("Anna", "P-001", {kNoFod}), says("Ben", "P-001", {kNotSure})},
                    Verdict::Open,
                    {}},
        VerdictCase{
            "DisagreementSettledByACorrection",
            kOne,
            {says("Anna", "P-001", {"hammer"}), says("Ben", "P-001", {kNoFod}), says("Ben", "P-001", {"hammer"})},
            Verdict::Finding,
            {"hammer"}},
        VerdictCase{"FodOnAnyPhotoIsAFinding",
                    kTwo,
                    {says("Anna", "P-001", {kNotSure}), says("Anna", "P-002", {"drill"})},
                    Verdict::Finding,
                    {"drill"}},
        VerdictCase{"OpenPhotoOutweighsNoFod",
                    kTwo,
                    {says("Anna", "P-001", {kNoFod}), says("Anna", "P-002", {kNotSure})},
                    Verdict::Open,
                    {}},
        VerdictCase{"WaitingPhotoOutweighsNoFod", kTwo, {says("Anna", "P-001", {kNoFod})}, Verdict::Undecided, {}},
        VerdictCase{"AllPhotosNoFod",
                    kTwo,
                    {says("Anna", "P-001", {kNoFod}), says("Anna", "P-002", {kNoFod})},
                    Verdict::NoFod,
                    {}},
        VerdictCase{"LabelOfAnotherSetIsStillFod", kOne, {says("Anna", "P-001", {"rag"})}, Verdict::Finding, {"rag"}}),
    [](const auto& info) { return info.param.name; });

TEST(Decisions, LastDecisionIsPerReaderAndPhoto) {
    const std::vector<Decision> decisions{says("Anna", "P-001", {"hammer"}), says("Ben", "P-001", {"drill"}),
                                          says("Anna", "P-002", {kNoFod}), says("Anna", "P-001", {kNotSure})};
    EXPECT_EQ(lastDecision(decisions, "P-001", "Anna"), &decisions[3]);
    EXPECT_EQ(lastDecision(decisions, "P-001", "Ben"), &decisions[1]);
    EXPECT_EQ(lastDecision(decisions, "P-002", "Ben"), nullptr);
    EXPECT_EQ(countingDecisions(decisions, "P-001"), (std::vector<const Decision*>{&decisions[3], &decisions[1]}));
}

TEST(Decisions, UndoReachesBackActByAct) {
    std::vector<Decision> decisions{says("Anna", "P-001", {"hammer"}), says("Anna", "P-001", {"drill"}),
                                    says("Ben", "P-002", {kNoFod}), says("Anna", "P-002", {kNotSure})};
    const auto first = undoOf(decisions, "Anna", {7});
    ASSERT_TRUE(first);
    EXPECT_EQ(first->photoId, "P-002");
    EXPECT_TRUE(first->labels.empty());
    EXPECT_EQ(first->time, UtcTime{7});
    decisions.push_back(*first);
    EXPECT_NE(lastDecision(decisions, "P-002", "Ben"), nullptr);

    const auto second = undoOf(decisions, "Anna", {8});
    ASSERT_TRUE(second);
    EXPECT_EQ(second->photoId, "P-001");
    EXPECT_EQ(second->labels, says("", "", {"hammer"}).labels);
    decisions.push_back(*second);

    const auto third = undoOf(decisions, "Anna", {9});
    ASSERT_TRUE(third);
    EXPECT_TRUE(third->labels.empty());
    decisions.push_back(*third);
    EXPECT_FALSE(undoOf(decisions, "Anna", {10}));

    decisions.push_back(says("Anna", "P-001", {kNoFod}));
    EXPECT_EQ(undoOf(decisions, "Anna", {11})->photoId, "P-001");
}

}  // namespace
}  // namespace fodscope
