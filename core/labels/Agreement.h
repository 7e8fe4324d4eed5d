// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace fodscope {

/// What each reader made of one item (a photo): the number of a category, empty where the reader did not read it.
using ItemRatings = std::vector<std::optional<std::size_t>>;

/// How far readers agree with each other. Kappa alone misleads where one category prevails, so raw agreement and AC1
/// stand beside it. Empty: undefined, e.g. with a single reader, or when chance alone would make everybody agree.
struct AgreementStatistics {
    std::size_t readers = 0;
    /// Items with at least two readers.
    std::size_t items = 0;
    /// Share of pairs of readings of the same item that agree, averaged over the items.
    std::optional<double> raw;
    /// Cohen (1960), for exactly two readers, over the items that both read.
    std::optional<double> cohenKappa;
    /// Fleiss (1971); items may have different numbers of readers (Gwet 2014).
    std::optional<double> fleissKappa;
    /// Gwet (2008).
    std::optional<double> gwetAc1;
};

/// @param items one entry a reader each
/// @param categories how many there are to choose from
/// @throws Error when items differ in their number of readers or a category is out of range
AgreementStatistics agreementOf(std::span<const ItemRatings> items, std::size_t categories);

}  // namespace fodscope
