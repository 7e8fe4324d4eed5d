// SPDX-License-Identifier: MIT
#include "core/evaluation/ReaderAgreement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/common/Error.h"

namespace fodscope {
namespace {

using nlohmann::json;
using testing::HasSubstr;

LabelSet tools() {
    return parseLabelSet("name: Tools\nlabels:\n  - {name: drill}\n  - {name: hammer}\n", "tools");
}

Decision decision(const std::string& photo, const std::string& reader, std::vector<std::string> labels,
                  std::int64_t time = 0) {
    Decision result;
    result.photoId = photo;
    result.labeller = reader;
    result.time = {time};
    for (const std::string& label : labels)
        result.labels.push_back({label, std::nullopt});
    return result;
}

ReadSession session(const std::string& id, std::vector<Decision> decisions, std::optional<ActualLabels> actual) {
    ReadSession result;
    result.file = id + ".fodscope";
    result.id = id;
    result.labelSet = tools();
    result.photoIds = {"P-001", "P-002"};
    result.decisions = std::move(decisions);
    result.actual = std::move(actual);
    result.truth = "world";
    return result;
}

const ActualLabels kTruth = {{"P-001", {"drill"}}, {"P-002", {}}};

bool isSimulated(const std::string& name) {
    return name == "simulation";
}

TEST(ReaderAgreement, CountsTheLastDecisionOfEachReader) {
    const std::vector<ReadSession> sessions = {session(
        "s",
        {decision("P-001", "Ann", {"hammer"}), decision("P-001", "Ann", {"drill"}), decision("P-002", "Ann", {kNoFod}),
         decision("P-001", "Bob", {"hammer"}), decision("P-002", "Bob", {kNotSure})},
        kTruth)};
    const ReaderAgreement result = readerAgreement(sessions, isSimulated);
    ASSERT_EQ(2u, result.readers.size());
    EXPECT_EQ("Ann", result.readers[0].name);
    EXPECT_DOUBLE_EQ(1.0, *result.readers[0].accuracy);
    EXPECT_DOUBLE_EQ(0.0, *result.readers[1].accuracy);
    EXPECT_EQ(4u, result.confusion->total());
    EXPECT_EQ(2u, result.confusion->correct());
    EXPECT_DOUBLE_EQ(0.5, *result.confusion->accuracy());
    EXPECT_EQ(2u, result.statistics.items);
    EXPECT_DOUBLE_EQ(0.0, *result.statistics.raw);
    EXPECT_EQ(4u, result.categories);
}

TEST(ReaderAgreement, PutsTheCopiesOfASessionTogether) {
    // Ann worked on one copy, Bob on another that already held a decision of Ann's.
    const std::vector<ReadSession> sessions = {
        session("s", {decision("P-001", "Ann", {"hammer"}, 1), decision("P-001", "Ann", {"drill"}, 5)}, kTruth),
        session("s", {decision("P-001", "Ann", {"hammer"}, 1), decision("P-001", "Bob", {"drill"}, 3)}, kTruth)};
    const ReaderAgreement result = readerAgreement(sessions, isSimulated);
    EXPECT_EQ(2u, result.photos);
    EXPECT_EQ(1u, result.photosWithoutReader);
    EXPECT_EQ(2u, result.confusion->total());
    EXPECT_DOUBLE_EQ(1.0, *result.confusion->accuracy());
    EXPECT_DOUBLE_EQ(1.0, *result.statistics.raw);
}

TEST(ReaderAgreement, KeepsPhotosOfDifferentSessionsApart) {
    const std::vector<ReadSession> sessions = {session("s", {decision("P-001", "Ann", {"drill"})}, kTruth),
                                               session("t", {decision("P-001", "Ann", {"drill"})}, kTruth)};
    EXPECT_EQ(4u, readerAgreement(sessions, isSimulated).photos);
    EXPECT_EQ(2u, readerAgreement(sessions, isSimulated).confusion->total());
}

TEST(ReaderAgreement, TakesSeveralLabelsOnAPhotoAsACategoryOfTheirOwn) {
    const std::vector<ReadSession> sessions = {
        session("s", {decision("P-001", "Ann", {"drill", "hammer"}), decision("P-001", "Bob", {"hammer", "drill"})},
                std::nullopt)};
    const ReaderAgreement result = readerAgreement(sessions, isSimulated);
    EXPECT_DOUBLE_EQ(1.0, *result.statistics.raw);
    EXPECT_EQ(5u, result.categories);
}

TEST(ReaderAgreement, HasNoMatrixWithoutTruth) {
    const std::vector<ReadSession> sessions = {session("s", {decision("P-001", "Ann", {"drill"})}, std::nullopt)};
    const ReaderAgreement result = readerAgreement(sessions, isSimulated);
    EXPECT_FALSE(result.confusion.has_value());
    EXPECT_FALSE(result.readers[0].accuracy.has_value());
    const json root = json::parse(agreementJson(result, sessions));
    EXPECT_TRUE(root["confusion_matrix"].is_null());
    EXPECT_TRUE(root["accuracy"].is_null());
    EXPECT_THAT(agreementText(result, sessions), HasSubstr("not known here"));
}

TEST(ReaderAgreement, LeavesOutWhoKnowsTheTruthWherePeopleHaveRead) {
    const std::vector<ReadSession> sessions = {
        session("s", {decision("P-001", "simulation", {"drill"}), decision("P-001", "Ann", {"hammer"})}, kTruth)};
    const ReaderAgreement result = readerAgreement(sessions, isSimulated);
    ASSERT_EQ(1u, result.readers.size());
    EXPECT_EQ("Ann", result.readers[0].name);
    EXPECT_EQ((std::vector<std::string>{"simulation"}), result.leftOut);

    const std::vector<ReadSession> alone = {session("s", {decision("P-001", "simulation", {"drill"})}, kTruth)};
    EXPECT_DOUBLE_EQ(1.0, *readerAgreement(alone, isSimulated).confusion->accuracy());
}

TEST(ReaderAgreement, SaysWhenNobodyHasRead) {
    EXPECT_THROW(readerAgreement(std::vector<ReadSession>{session("s", {}, kTruth)}, isSimulated), Error);
    EXPECT_THROW(readerAgreement({}, isSimulated), Error);
}

TEST(ReaderAgreement, WritesMatrixAccuracyAndStatistics) {
    const std::vector<ReadSession> sessions = {
        session("s", {decision("P-001", "Ann", {"drill"}), decision("P-002", "Ann", {kNoFod})}, kTruth)};
    const json root = json::parse(agreementJson(readerAgreement(sessions, isSimulated), sessions));
    EXPECT_EQ(json({"drill", kNoFod, kMixed}), root["confusion_matrix"]["columns"]);
    EXPECT_EQ(json({"drill", kNoFod, kMixed, kMissed, kNotSure}), root["confusion_matrix"]["rows"]);
    EXPECT_EQ(1, root["confusion_matrix"]["counts"][0][0]);
    EXPECT_EQ(1.0, root["accuracy"]);
    EXPECT_TRUE(root["agreement"]["raw"].is_null());
    EXPECT_EQ("world", root["sessions"][0]["truth"]);
}

}  // namespace
}  // namespace fodscope
