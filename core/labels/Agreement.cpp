// SPDX-License-Identifier: MIT
#include "core/labels/Agreement.h"

#include <algorithm>

#include "core/common/Error.h"

namespace fodscope {
namespace {

constexpr double kNoRoom = 1e-12;

/// @return (observed − chance) / (1 − chance), empty where chance leaves no room
std::optional<double> beyondChance(double observed, double chance) {
    if (1.0 - chance < kNoRoom) return std::nullopt;
    return (observed - chance) / (1.0 - chance);
}

void requireRatings(std::span<const ItemRatings> items, std::size_t categories) {
    for (const ItemRatings& item : items) {
        if (item.size() != items.front().size())
            throw Error("agreement", "items differ in their number of readers",
                        "give one entry a reader for each item");
        for (const auto& rating : item)
            if (rating && *rating >= categories)
                throw Error("agreement", "a category is out of range", "count all categories");
    }
}

std::vector<double> countsOf(const ItemRatings& item, std::size_t categories) {
    std::vector<double> counts(categories, 0.0);
    for (const auto& rating : item)
        if (rating) ++counts[*rating];
    return counts;
}

double sumOf(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    return sum;
}

std::optional<double> cohenKappa(std::span<const ItemRatings> items, std::size_t categories) {
    std::vector<double> first(categories, 0.0), second(categories, 0.0);
    double both = 0.0, agreed = 0.0;
    for (const ItemRatings& item : items) {
        if (!item[0] || !item[1]) continue;
        ++both;
        ++first[*item[0]];
        ++second[*item[1]];
        if (*item[0] == *item[1]) ++agreed;
    }
    if (both == 0.0) return std::nullopt;
    double chance = 0.0;
    for (std::size_t k = 0; k < categories; ++k)
        chance += (first[k] / both) * (second[k] / both);
    return beyondChance(agreed / both, chance);
}

}  // namespace

AgreementStatistics agreementOf(std::span<const ItemRatings> items, std::size_t categories) {
    AgreementStatistics result;
    if (items.empty()) return result;
    requireRatings(items, categories);
    result.readers = items.front().size();
    std::vector<double> prevalence(categories, 0.0);
    double rated = 0.0, agreement = 0.0;
    for (const ItemRatings& item : items) {
        const std::vector<double> counts = countsOf(item, categories);
        const double readings = sumOf(counts);
        if (readings < 1.0) continue;
        ++rated;
        double pairs = 0.0;
        for (std::size_t k = 0; k < categories; ++k) {
            prevalence[k] += counts[k] / readings;
            pairs += counts[k] * (counts[k] - 1.0);
        }
        if (readings < 2.0) continue;
        ++result.items;
        agreement += pairs / (readings * (readings - 1.0));
    }
    if (result.items == 0) return result;
    const double raw = agreement / static_cast<double>(result.items);
    double fleissChance = 0.0, gwetChance = 0.0;
    for (double share : prevalence) {
        share /= rated;
        fleissChance += share * share;
        gwetChance += share * (1.0 - share);
    }
    result.raw = raw;
    result.fleissKappa = beyondChance(raw, fleissChance);
    if (categories > 1) result.gwetAc1 = beyondChance(raw, gwetChance / static_cast<double>(categories - 1));
    if (result.readers == 2) result.cohenKappa = cohenKappa(items, categories);
    return result;
}

}  // namespace fodscope
