// SPDX-License-Identifier: MIT
#include "core/evaluation/Wilcoxon.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/common/Error.h"
#include "core/common/Files.h"

namespace fodscope {
namespace {

using nlohmann::json;

TEST(Wilcoxon, GivesScipysStatisticsAndPValues) {
    const json fixture = json::parse(readTextFile(std::string(FODSCOPE_TEST_DATA) + "/wilcoxon/wilcoxon.json"));
    ASSERT_GT(fixture["cases"].size(), 20u);
    for (const json& one : fixture["cases"]) {
        SCOPED_TRACE(one["name"].get<std::string>());
        const auto differences = one["differences"].get<std::vector<double>>();
        const WilcoxonResult result = wilcoxonSignedRank(differences);
        EXPECT_EQ(differences.size(), result.pairs);
        ASSERT_EQ(one["less"].is_null(), !result.less.has_value());
        ASSERT_EQ(one["greater"].is_null(), !result.greater.has_value());
        if (one["less"].is_null()) continue;
        EXPECT_DOUBLE_EQ(one["statistic"].get<double>(), *result.statistic);
        EXPECT_NEAR(one["less"].get<double>(), *result.less, 1e-12);
        EXPECT_NEAR(one["greater"].get<double>(), *result.greater, 1e-12);
    }
}

TEST(Wilcoxon, HasNoPValueWhereNothingDiffers) {
    EXPECT_FALSE(wilcoxonSignedRank(std::vector<double>{}).less.has_value());
    const WilcoxonResult zeros = wilcoxonSignedRank(std::vector<double>{0.0, 0.0, -0.0});
    EXPECT_EQ(3u, zeros.zeros);
    EXPECT_FALSE(zeros.statistic.has_value());
    EXPECT_FALSE(zeros.less.has_value());
    EXPECT_FALSE(zeros.greater.has_value());
}

TEST(Wilcoxon, TellsWhichWayItWasComputed) {
    EXPECT_EQ(WilcoxonMethod::Exact, wilcoxonSignedRank(std::vector<double>(50, 1.0)).method);
    EXPECT_EQ(WilcoxonMethod::Normal, wilcoxonSignedRank(std::vector<double>(51, 1.0)).method);
    EXPECT_EQ(WilcoxonMethod::Normal, wilcoxonSignedRank(std::vector<double>{0.0, 1.0}).method);
}

TEST(Wilcoxon, IsSymmetric) {
    const WilcoxonResult one = wilcoxonSignedRank(std::vector<double>{1, 2, -3, 4, 5.5});
    const WilcoxonResult other = wilcoxonSignedRank(std::vector<double>{-1, -2, 3, -4, -5.5});
    EXPECT_DOUBLE_EQ(*one.less, *other.greater);
    EXPECT_DOUBLE_EQ(*one.greater, *other.less);
}

TEST(Wilcoxon, RefusesWhatIsNoNumber) {
    EXPECT_THROW(wilcoxonSignedRank(std::vector<double>{1.0, std::numeric_limits<double>::quiet_NaN()}), Error);
    EXPECT_THROW(wilcoxonSignedRank(std::vector<double>{std::numeric_limits<double>::infinity()}), Error);
}

}  // namespace
}  // namespace fodscope
