// SPDX-License-Identifier: MIT
#include "core/evaluation/SearchReport.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "core/evaluation/CostSurface.h"

namespace fodscope {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

ParameterSearchResult exampleResult() {
    ParameterSearchResult result;
    result.trialCount = 2;
    result.fodCount = 7;
    result.cutoffs_m = {0.1, 0.2, 0.3};
    result.thresholds = {1.5, 2.25, 3.0};
    result.leastPoints = {0, 1};
    for (int i = 0; i < 18; ++i)
        result.costs.push_back({1.0 + i, 0.5, 3.0, 4.0});
    result.best = {1, 1, 1};
    result.costs[(1 * 3 + 1) * 2 + 1] = {0.45, 0.3, 3.0, 5.5};
    return result;
}

TEST(SearchReport, TellsTheBestValuesAndTheirCost) {
    const auto lines = searchFindings(exampleResult());
    EXPECT_THAT(
        lines, ElementsAre("Best of 18 grid points over 2 trials with 7 FOD: threshold 2.2500, cluster cutoff 0.200 m, "
                           "least points 1 (mahalanobis, centroid linkage).",
                           "Mean cost 0.4500 m per trial: its FOD lie 0.300 m from their nearest candidates, and 3.00 "
                           "of 5.50 candidates are no FOD's nearest one, 0.05 m each.",
                           HasSubstr("The best least points is the last one on the grid")));
}

TEST(SearchReport, WarnsOfABestPointAtTheBorderOfTheGrid) {
    ParameterSearchResult result = exampleResult();
    result.best = {0, 2, 0};
    const auto lines = searchFindings(result);
    ASSERT_EQ(lines.size(), 4u);
    EXPECT_THAT(lines[2], HasSubstr("cluster cutoff"));
    EXPECT_THAT(lines[3], HasSubstr("threshold"));
}

TEST(SearchReport, TellsTheGridAndTheCostFunction) {
    ParameterSearchResult result = exampleResult();
    result.settings.metric = Metric::Euclidean;
    result.settings.linkage = Linkage::Single;
    std::string text;
    for (const std::string& line : searchMethod(result))
        text += line + "\n";
    EXPECT_THAT(text,
                HasSubstr("3 cluster cutoffs from 0.1 to 0.3 m, 3 thresholds from 1.5 to 3 m, least points 0 to 1"));
    EXPECT_THAT(text, HasSubstr("percentile 25"));
    EXPECT_THAT(text, HasSubstr("lambda 0.05 m"));
    EXPECT_THAT(text, HasSubstr("euclidean, single linkage"));
    result.settings.lowestThreshold = 1.5;
    for (const std::string& line : searchMethod(result))
        EXPECT_THAT(line, Not(HasSubstr("percentile")));
}

TEST(CostSurface, ListsEveryGridPoint) {
    const std::string csv = costSurfaceCsv(exampleResult());
    EXPECT_EQ(std::ranges::count(csv, '\n'), 19);
    EXPECT_THAT(csv, StartsWith("cluster_cutoff_m,threshold,least_points,cost,distance_m,unassociated_candidates,"
                                "candidates\n0.1,1.5,0,1,0.5,3,4\n0.1,1.5,1,2,0.5,3,4\n0.1,2.25,0,3,0.5,3,4\n"));
    EXPECT_THAT(csv, HasSubstr("\n0.2,2.25,1,0.45,0.3,3,5.5\n"));
}

TEST(CostSurface, IsAPictureEvenOfOnePointWithoutCost) {
    ParameterSearchResult result;
    result.cutoffs_m = {0.1};
    result.thresholds = {1.0};
    result.leastPoints = {0};
    result.costs = {{}};
    for (const ParameterSearchResult& one : {exampleResult(), result}) {
        const auto png = costSurfacePng(one);
        ASSERT_GT(png.size(), 1000u);
        EXPECT_EQ(std::to_integer<int>(png[1]), 'P');
        EXPECT_EQ(png, costSurfacePng(one));
    }
}

}  // namespace
}  // namespace fodscope
