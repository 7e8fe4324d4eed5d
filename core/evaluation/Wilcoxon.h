// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>

namespace fodscope {

enum class WilcoxonMethod {
    Exact,  ///< by the distribution of the rank sum
    Normal  ///< by its normal approximation, without continuity correction, corrected for ties
};

/// What a one-sided Wilcoxon signed-rank test says about paired differences.
struct WilcoxonResult {
    /// Pairs, and those among them that do not differ.
    std::size_t pairs = 0;
    std::size_t zeros = 0;
    /// Sum of the ranks of the positive differences.
    std::optional<double> statistic;
    /// p-value for "the differences tend to be smaller than zero" and for "greater". Empty when there is no pair that
    /// differs: nothing can be tested then.
    std::optional<double> less;
    std::optional<double> greater;
    WilcoxonMethod method = WilcoxonMethod::Exact;
};

/// As scipy.stats.wilcoxon 1.10 with its defaults (zero_method "wilcox", correction False, method "auto"): exact for at
/// most 50 pairs of which none has a zero difference, else by the normal approximation over the pairs that differ.
/// Equal magnitudes share their mean rank; in the exact case a rank sum that is then not whole is cut to a whole one,
/// as scipy does. Where scipy raises an error (all differences zero) or returns NaN (no pairs), there is no p-value.
/// @throws Error for a difference that is not finite
WilcoxonResult wilcoxonSignedRank(std::span<const double> differences);

}  // namespace fodscope
