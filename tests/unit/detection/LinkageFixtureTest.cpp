// SPDX-License-Identifier: MIT
// Partitions against scipy's, where no two merge distances tie; tests/data/clustering/make_fixture.py made the files.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "core/detection/HierarchicalClustering.h"
#include "tests/unit/detection/BruteForceClusters.h"

namespace fodscope {
namespace {

struct Expectation {
    Linkage linkage = Linkage::Centroid;
    double cutoff_m = 0.0;
    Labels labels;
};

struct Fixture {
    std::vector<Eigen::Vector3d> points;
    std::vector<Expectation> expectations;
};

Fixture readFixture(const std::string& name) {
    Fixture fixture;
    std::ifstream file(std::string(FODSCOPE_TEST_DATA) + "/clustering/" + name + ".csv");
    std::string line;
    std::getline(file, line);
    std::istringstream header(line);
    for (std::string word; std::getline(header, word, ',');) {
        const std::size_t space = word.find(' ');
        if (space == std::string::npos) continue;
        const Linkage linkage = word.substr(0, space) == "single" ? Linkage::Single : Linkage::Centroid;
        fixture.expectations.push_back({linkage, std::stod(word.substr(space + 1)), {}});
    }
    while (std::getline(file, line)) {
        std::istringstream row(line);
        std::vector<double> values;
        for (std::string word; std::getline(row, word, ',');)
            values.push_back(std::stod(word));
        fixture.points.emplace_back(values.at(0), values.at(1), values.at(2));
        for (std::size_t i = 0; i < fixture.expectations.size(); ++i)
            fixture.expectations[i].labels.push_back(static_cast<std::uint32_t>(values.at(3 + i)));
    }
    return fixture;
}

class LinkageFixture : public ::testing::TestWithParam<const char*> {};

TEST_P(LinkageFixture, GivesThePartitionsOfScipy) {
    const Fixture fixture = readFixture(GetParam());
    ASSERT_GT(fixture.points.size(), 200u);
    ASSERT_GT(fixture.expectations.size(), 10u);
    Progress progress;
    for (const Expectation& expected : fixture.expectations) {
        const auto labels = linkageClusters(fixture.points, expected.linkage, expected.cutoff_m, progress);
        EXPECT_EQ(labels, expected.labels)
            << (expected.linkage == Linkage::Single ? "single " : "centroid ") << expected.cutoff_m;
    }
}

TEST_P(LinkageFixture, OneSequenceServesAllSmallerCutoffs) {
    const Fixture fixture = readFixture(GetParam());
    Progress progress;
    for (const Linkage linkage : {Linkage::Centroid, Linkage::Single}) {
        const MergeSequence sequence = mergeSequence(fixture.points, linkage, 1.0, progress);
        for (const Expectation& expected : fixture.expectations) {
            if (expected.linkage != linkage) continue;
            EXPECT_EQ(clustersAt(sequence, expected.cutoff_m), expected.labels) << expected.cutoff_m;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scipy, LinkageFixture, ::testing::Values("clustered", "random", "collinear", "surface"));

}  // namespace
}  // namespace fodscope
