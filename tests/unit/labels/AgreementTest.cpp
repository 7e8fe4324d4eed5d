// SPDX-License-Identifier: MIT
#include "core/labels/Agreement.h"

#include <gtest/gtest.h>

#include "core/common/Error.h"

namespace fodscope {
namespace {

/// Two readers, from their table of counts.
std::vector<ItemRatings> fromTable(const std::vector<std::vector<int>>& table) {
    std::vector<ItemRatings> items;
    for (std::size_t first = 0; first < table.size(); ++first)
        for (std::size_t second = 0; second < table.size(); ++second)
            for (int i = 0; i < table[first][second]; ++i)
                items.push_back({first, second});
    return items;
}

/// Many readers of whom only the number in each category is known.
std::vector<ItemRatings> fromCounts(const std::vector<std::vector<std::size_t>>& counts) {
    std::vector<ItemRatings> items;
    for (const auto& row : counts) {
        ItemRatings item;
        for (std::size_t category = 0; category < row.size(); ++category)
            item.insert(item.end(), row[category], category);
        items.push_back(std::move(item));
    }
    return items;
}

TEST(Agreement, GivesCohensKappaOfTheGrantProposals) {
    // The worked example of the textbooks: 50 proposals, both yes 20, both no 15.
    const AgreementStatistics result = agreementOf(fromTable({{20, 5}, {10, 15}}), 2);
    EXPECT_NEAR(0.4, *result.cohenKappa, 1e-12);
    EXPECT_NEAR(0.7, *result.raw, 1e-12);
    EXPECT_EQ(50u, result.items);
    EXPECT_EQ(2u, result.readers);
}

TEST(Agreement, GivesFleissKappaOfThePublishedTable) {
    // 10 subjects, 14 raters, 5 categories: 0.210.
    const AgreementStatistics result = agreementOf(fromCounts({{0, 0, 0, 0, 14},
                                                               {0, 2, 6, 4, 2},
                                                               {0, 0, 3, 5, 6},
                                                               {0, 3, 9, 2, 0},
                                                               {2, 2, 8, 1, 1},
                                                               {7, 7, 0, 0, 0},
                                                               {3, 2, 6, 3, 0},
                                                               {2, 5, 3, 2, 2},
                                                               {6, 5, 2, 1, 0},
                                                               {0, 2, 2, 3, 7}}),
                                                   5);
    EXPECT_NEAR(0.378, *result.raw, 5e-4);
    EXPECT_NEAR(0.210, *result.fleissKappa, 5e-4);
    EXPECT_FALSE(result.cohenKappa.has_value());
}

TEST(Agreement, GivesGwetsAc1WhereKappaIsAParadox) {
    // Gwet (2008): 125 subjects, raters agree on 118 of them, and yet kappa is below zero.
    const AgreementStatistics result = agreementOf(fromTable({{118, 5}, {2, 0}}), 2);
    EXPECT_NEAR(0.944, *result.raw, 1e-12);
    EXPECT_NEAR(-0.0234, *result.cohenKappa, 5e-5);
    EXPECT_NEAR(0.9408, *result.gwetAc1, 5e-5);
}

TEST(Agreement, IsOneWhereAllAgreeAndMoreThanOneCategoryOccurs) {
    const AgreementStatistics result = agreementOf(fromTable({{3, 0}, {0, 4}}), 2);
    EXPECT_DOUBLE_EQ(1.0, *result.raw);
    EXPECT_DOUBLE_EQ(1.0, *result.cohenKappa);
    EXPECT_DOUBLE_EQ(1.0, *result.fleissKappa);
    EXPECT_DOUBLE_EQ(1.0, *result.gwetAc1);
}

TEST(Agreement, KappaIsUndefinedWhereOnlyOneCategoryOccurs) {
    const AgreementStatistics result = agreementOf(fromTable({{5, 0}, {0, 0}}), 2);
    EXPECT_DOUBLE_EQ(1.0, *result.raw);
    EXPECT_FALSE(result.cohenKappa.has_value());
    EXPECT_FALSE(result.fleissKappa.has_value());
    EXPECT_DOUBLE_EQ(1.0, *result.gwetAc1);
}

TEST(Agreement, TakesItemsThatNotEveryReaderRead) {
    const std::vector<ItemRatings> items = {{0, 0, {}}, {0, 1, 1}, {{}, {}, 1}, {{}, {}, {}}};
    const AgreementStatistics result = agreementOf(items, 2);
    EXPECT_EQ(2u, result.items);
    // The first item agrees wholly, of the second one pair in three.
    EXPECT_NEAR((1.0 + 1.0 / 3.0) / 2.0, *result.raw, 1e-12);
}

TEST(Agreement, IsUndefinedForOneReaderOrNone) {
    EXPECT_FALSE(agreementOf({}, 2).raw.has_value());
    const AgreementStatistics result = agreementOf(std::vector<ItemRatings>{{0}, {1}}, 2);
    EXPECT_EQ(0u, result.items);
    EXPECT_FALSE(result.raw.has_value());
}

TEST(Agreement, RefusesWhatIsNotLaidOutRight) {
    EXPECT_THROW(agreementOf(std::vector<ItemRatings>{{0, 1}, {0}}, 2), Error);
    EXPECT_THROW(agreementOf(std::vector<ItemRatings>{{0, 2}}, 2), Error);
}

}  // namespace
}  // namespace fodscope
