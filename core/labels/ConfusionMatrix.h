// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace fodscope {

/// Several FOD, or several labels, of which it cannot be told which was meant by which (paper: "mixed FOD").
inline constexpr const char* kMixed = "mixed";
/// A FOD that a reader left unlabelled on a photo on which the reader labelled others.
inline constexpr const char* kMissed = "missed";

/// One count: what was said (row) of what was there (column).
struct ConfusionEntry {
    std::string labelled;
    std::string actual;

    bool operator==(const ConfusionEntry&) const = default;
};

/// What one reading of one photo adds to a confusion matrix. Labels that name a FOD on the photo are right. Of what is
/// left over: `no FOD` and `not sure` go to the FOD's column, or to `mixed` when there are several; one wrong label and
/// one FOD left go to their cell; labels without a FOD left go to column `no FOD`, FOD without a label left to row
/// `missed`; anything else is `mixed`.
/// @param labelled FOD labels, or `no FOD` alone, and perhaps `not sure`; empty counts as not read and adds nothing
/// @param actual FOD on the photo; empty: none
std::vector<ConfusionEntry> confusionEntries(const std::set<std::string>& labelled,
                                             const std::set<std::string>& actual);

/// Rows labelled, columns actual.
struct ConfusionMatrix {
    std::vector<std::string> rows;
    std::vector<std::string> columns;
    std::vector<std::vector<std::size_t>> counts;

    std::size_t total() const;
    /// Cells whose row and column are the same; `mixed` is never right.
    std::size_t correct() const;
    /// Correct over total, so `not sure` counts as wrong; empty without readings.
    std::optional<double> accuracy() const;
};

/// Types that occur, by name, then `no FOD`, `mixed` in both, `missed` and `not sure` in the rows.
ConfusionMatrix confusionMatrix(const std::vector<ConfusionEntry>& entries);

}  // namespace fodscope
