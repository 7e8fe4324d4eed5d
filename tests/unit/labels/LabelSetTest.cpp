// SPDX-License-Identifier: MIT
#include "core/labels/LabelSet.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/common/Error.h"

namespace fodscope {
namespace {

std::string problemOf(const std::string& yaml) {
    try {
        parseLabelSet(yaml, "labels.yaml");
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(LabelSet, NoFodAndNotSureAreAlwaysTheLastTwo) {
    const LabelSet set = parseLabelSet("{name: Tools, labels: [{name: hammer, key: 1}, {name: drill, key: d}]}", "x");
    ASSERT_EQ(set.labels.size(), 4u);
    EXPECT_EQ(set.name, "Tools");
    EXPECT_EQ(set.labels[0], (Label{"hammer", '1', LabelKind::Fod}));
    EXPECT_EQ(set.labels[1], (Label{"drill", 'D', LabelKind::Fod}));
    EXPECT_EQ(set.labels[2], (Label{"no FOD", '0', LabelKind::NoFod}));
    EXPECT_EQ(set.labels[3], (Label{"not sure", 'U', LabelKind::NotSure}));
}

TEST(LabelSet, LabelsWithoutAKeyGetTheLowestFreeDigit) {
    const LabelSet set = parseLabelSet("{name: T, labels: [bolt, {name: nut, key: 1}, {name: rag}]}", "x");
    EXPECT_EQ(set.find("bolt")->key, '2');
    EXPECT_EQ(set.find("nut")->key, '1');
    EXPECT_EQ(set.find("rag")->key, '3');
}

TEST(LabelSet, EveryShippedSetReadsAndHoldsItsStudysTools) {
    const std::filesystem::path folder = std::filesystem::path(FODSCOPE_RESOURCES) / "labels";
    const LabelSet trials = readLabelSet(folder / "physical-trials.yaml");
    for (const char* type : {"hammer", "drill", "tape_measure", "screwdriver", "sander", "crimper"}) {
        EXPECT_NE(findByType(trials, type), nullptr) << type;
    }
    EXPECT_EQ(trials.labels.size(), 8u);
    const LabelSet simulation = readLabelSet(folder / "simulation.yaml");
    for (const char* type : {"drill", "screwdriver", "hammer", "wrench", "level", "sander"}) {
        EXPECT_NE(findByType(simulation, type), nullptr) << type;
    }
    EXPECT_EQ(simulation.labels.size(), 8u);
    const LabelSet both = readLabelSet(folder / "default.yaml");
    for (const LabelSet* part : {&trials, &simulation}) {
        for (const Label& label : part->labels) {
            EXPECT_NE(both.find(label.name), nullptr) << label.name;
        }
    }
}

TEST(LabelSet, WorldTypesMatchLabelsWhateverTheirSeparatorsAndCase) {
    const LabelSet set = parseLabelSet("{name: T, labels: [tape measure]}", "x");
    EXPECT_EQ(findByType(set, "tape_measure"), set.find("tape measure"));
    EXPECT_EQ(findByType(set, "Tape-Measure"), set.find("tape measure"));
    EXPECT_EQ(findByType(set, "tape"), nullptr);
}

TEST(LabelSet, SaysWhatIsWrongWithAFile) {
    EXPECT_NE(problemOf("").find("has no labels"), std::string::npos);
    EXPECT_NE(problemOf("{name: T, labels: []}").find("has no labels"), std::string::npos);
    EXPECT_NE(problemOf("{labels: [hammer]}").find("no name"), std::string::npos);
    EXPECT_NE(problemOf("{name: T, labels: [a, A]}").find("twice"), std::string::npos);
    EXPECT_NE(problemOf("{name: T, labels: [{name: a, key: 1}, {name: b, key: 1}]}").find("twice"), std::string::npos);
    EXPECT_NE(problemOf("{name: T, labels: [{name: a, key: 0}]}").find("taken"), std::string::npos);
    EXPECT_NE(problemOf("{name: T, labels: [{name: a, key: u}]}").find("taken"), std::string::npos);
    EXPECT_NE(problemOf("{name: T, labels: [{name: a, key: F1}]}").find("no key"), std::string::npos);
    EXPECT_NE(problemOf("{name: T, labels: [not sure]}").find("taken"), std::string::npos);
    EXPECT_NE(problemOf("{name: T, labels: [{name: a, colour: red}]}").find("colour"), std::string::npos);
    EXPECT_NE(problemOf("{name: T, labels: [a").find("not valid YAML"), std::string::npos);
    EXPECT_NE(problemOf("{name: T, labels: [a, b, c, d, e, f, g, h, i, j]}").find("no digit is left"),
              std::string::npos);
    EXPECT_THROW(readLabelSet("/nowhere/labels.yaml"), Error);
}

}  // namespace
}  // namespace fodscope
