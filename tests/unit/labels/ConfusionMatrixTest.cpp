// SPDX-License-Identifier: MIT
#include "core/labels/ConfusionMatrix.h"

#include <gtest/gtest.h>

#include "core/labels/LabelSet.h"

namespace fodscope {
namespace {

using Entries = std::vector<ConfusionEntry>;
using Names = std::set<std::string>;

TEST(ConfusionMatrix, GivesThePapersAccuracyFromItsFirstMatrix) {
    ConfusionMatrix paper;
    paper.columns = {"hammer", "level", "screwdriver", "wrench", "sander", "drill", kNoFod, kMixed};
    paper.rows = {"hammer", "level", "screwdriver", "wrench", "sander", "drill", kNoFod, kNotSure};
    paper.counts = {{6, 0, 0, 0, 0, 0, 0, 1},   {0, 17, 0, 0, 0, 0, 0, 0}, {0, 0, 33, 0, 0, 0, 0, 0},
                    {0, 0, 0, 20, 0, 0, 0, 0},  {0, 0, 0, 0, 2, 0, 0, 0},  {0, 0, 0, 0, 0, 11, 0, 0},
                    {0, 0, 1, 4, 6, 0, 163, 0}, {2, 13, 0, 8, 1, 2, 3, 0}};
    EXPECT_EQ(252u, paper.correct());
    EXPECT_EQ(293u, paper.total());
    EXPECT_NEAR(0.860, *paper.accuracy(), 5e-4);
}

TEST(ConfusionMatrix, IsTheSameWhenItIsCountedFromReadings) {
    Entries entries;
    const auto add = [&](int times, const Names& labelled, const Names& actual) {
        for (int i = 0; i < times; ++i)
            for (const ConfusionEntry& entry : confusionEntries(labelled, actual))
                entries.push_back(entry);
    };
    add(6, {"hammer"}, {"hammer"});
    add(1, {"hammer"}, {"drill", "wrench"});
    add(17, {"level"}, {"level"});
    add(33, {"screwdriver"}, {"screwdriver"});
    add(20, {"wrench"}, {"wrench"});
    add(2, {"sander"}, {"sander"});
    add(11, {"drill"}, {"drill"});
    add(1, {kNoFod}, {"screwdriver"});
    add(4, {kNoFod}, {"wrench"});
    add(6, {kNoFod}, {"sander"});
    add(163, {kNoFod}, {});
    add(2, {kNotSure}, {"hammer"});
    add(13, {kNotSure}, {"level"});
    add(8, {kNotSure}, {"wrench"});
    add(1, {kNotSure}, {"sander"});
    add(2, {kNotSure}, {"drill"});
    add(3, {kNotSure}, {});
    const ConfusionMatrix matrix = confusionMatrix(entries);
    EXPECT_EQ(252u, matrix.correct());
    EXPECT_EQ(293u, matrix.total());
    EXPECT_EQ((std::vector<std::string>{"drill", "hammer", "level", "sander", "screwdriver", "wrench", kNoFod, kMixed}),
              matrix.columns);
    EXPECT_EQ((std::vector<std::string>{"drill", "hammer", "level", "sander", "screwdriver", "wrench", kNoFod, kMixed,
                                        kMissed, kNotSure}),
              matrix.rows);
    EXPECT_EQ(1u, matrix.counts[1][7]);
    EXPECT_EQ(13u, matrix.counts[9][2]);
}

TEST(ConfusionEntries, TakeALabelThatNamesAFodAsRight) {
    EXPECT_EQ((Entries{{"drill", "drill"}}), confusionEntries({"drill"}, {"drill"}));
    EXPECT_EQ((Entries{{"drill", "drill"}, {"level", "level"}}),
              confusionEntries({"drill", "level"}, {"drill", "level"}));
}

TEST(ConfusionEntries, TellWhatWasTakenForWhat) {
    EXPECT_EQ((Entries{{"drill", "sander"}}), confusionEntries({"drill"}, {"sander"}));
    EXPECT_EQ((Entries{{"level", "level"}, {"drill", "sander"}}),
              confusionEntries({"drill", "level"}, {"sander", "level"}));
    EXPECT_EQ((Entries{{"drill", kNoFod}}), confusionEntries({"drill"}, {}));
    EXPECT_EQ((Entries{{kNoFod, "drill"}}), confusionEntries({kNoFod}, {"drill"}));
    EXPECT_EQ((Entries{{kNoFod, kNoFod}}), confusionEntries({kNoFod}, {}));
}

TEST(ConfusionEntries, CountFodThatWasLeftUnlabelledBesideOthersAsMissed) {
    EXPECT_EQ((Entries{{"drill", "drill"}, {kMissed, "level"}}), confusionEntries({"drill"}, {"drill", "level"}));
}

TEST(ConfusionEntries, AreMixedWhereItCannotBeToldWhichWasMeant) {
    EXPECT_EQ((Entries{{"hammer", kMixed}}), confusionEntries({"hammer"}, {"drill", "level"}));
    EXPECT_EQ((Entries{{kMixed, kMixed}}), confusionEntries({"hammer", "wrench"}, {"drill", "level"}));
    EXPECT_EQ((Entries{{kMixed, "drill"}}), confusionEntries({"hammer", "wrench"}, {"drill"}));
    EXPECT_EQ((Entries{{kNoFod, kMixed}}), confusionEntries({kNoFod}, {"drill", "level"}));
}

TEST(ConfusionEntries, KeepNotSureAsALabelThatIsNeverRight) {
    EXPECT_EQ((Entries{{kNotSure, "drill"}}), confusionEntries({kNotSure}, {"drill"}));
    EXPECT_EQ((Entries{{kNotSure, kNoFod}}), confusionEntries({kNotSure}, {}));
    EXPECT_EQ((Entries{{kNotSure, kMixed}}), confusionEntries({kNotSure}, {"drill", "level"}));
    EXPECT_EQ(0u, confusionMatrix(confusionEntries({kNotSure}, {})).correct());
}

TEST(ConfusionEntries, AddNothingForAPhotoThatWasNotRead) {
    EXPECT_TRUE(confusionEntries({}, {"drill"}).empty());
    EXPECT_FALSE(confusionMatrix({}).accuracy().has_value());
}

TEST(ConfusionMatrix, NeverTakesMixedAsRight) {
    const ConfusionMatrix matrix = confusionMatrix(confusionEntries({"hammer", "wrench"}, {"drill", "level"}));
    EXPECT_EQ(1u, matrix.total());
    EXPECT_EQ(0u, matrix.correct());
}

}  // namespace
}  // namespace fodscope
