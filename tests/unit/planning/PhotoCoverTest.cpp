// SPDX-License-Identifier: MIT
#include "core/planning/PhotoCover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace fodscope {
namespace {

std::set<std::size_t> coveredBy(const std::vector<CoverSet>& sets, const std::vector<std::size_t>& chosen) {
    std::set<std::size_t> covered;
    for (const std::size_t set : chosen)
        covered.insert(sets[set].elements.begin(), sets[set].elements.end());
    return covered;
}

double costOf(const std::vector<CoverSet>& sets, const std::vector<std::size_t>& chosen) {
    double cost = 0.0;
    for (const std::size_t set : chosen)
        cost += sets[set].cost;
    return cost;
}

TEST(PhotoCover, isTheLeastOfAllChoicesThatBruteForceTries) {
    std::mt19937 random(3);
    for (int trial = 0; trial < 300; ++trial) {
        const std::size_t elements = 1 + random() % 8;
        std::vector<CoverSet> sets(1 + random() % 11);
        for (CoverSet& set : sets) {
            for (std::size_t element = 0; element < elements; ++element)
                if (random() % 3 == 0) set.elements.push_back(element);
            set.cost = static_cast<double>(random() % 5);
        }
        std::vector<std::size_t> all(sets.size());
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = i;
        const auto wanted = coveredBy(sets, all);
        std::pair<std::size_t, double> least{1000, 0.0};
        for (unsigned mask = 0; mask < 1U << sets.size(); ++mask) {
            std::vector<std::size_t> some;
            for (std::size_t i = 0; i < sets.size(); ++i)
                if ((mask >> i & 1U) != 0) some.push_back(i);
            if (coveredBy(sets, some) == wanted) least = std::min(least, std::pair(some.size(), costOf(sets, some)));
        }
        const auto chosen = fewestSets(sets, elements);
        EXPECT_EQ(coveredBy(sets, chosen), wanted);
        EXPECT_EQ(chosen.size(), least.first);
        EXPECT_EQ(costOf(sets, chosen), least.second);
        EXPECT_EQ(fewestSets(sets, elements), chosen);
    }
}

TEST(PhotoCover, coversHundredsOfElementsToo) {
    std::mt19937 random(5);
    std::vector<CoverSet> sets(3000);
    for (std::size_t i = 0; i < sets.size(); ++i) {
        const std::size_t first = random() % 300;
        for (std::size_t element = first; element < std::min<std::size_t>(300, first + 1 + random() % 5); ++element)
            sets[i].elements.push_back(element);
        sets[i].cost = static_cast<double>(random() % 100);
    }
    const auto chosen = fewestSets(sets, 300);
    std::vector<std::size_t> all(sets.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = i;
    EXPECT_EQ(coveredBy(sets, chosen), coveredBy(sets, all));
    EXPECT_LT(chosen.size(), 90U) << "sixty sets of five would do at best";
}

TEST(PhotoCover, nothingToCoverNeedsNothing) {
    EXPECT_TRUE(fewestSets({}, 0).empty());
    EXPECT_TRUE(fewestSets({}, 3).empty());
}

}  // namespace
}  // namespace fodscope
