// SPDX-License-Identifier: MIT
#include "core/evaluation/Wilcoxon.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "core/common/Error.h"

namespace fodscope {
namespace {

constexpr std::size_t kMostExactPairs = 50;

struct RankSum {
    double positive = 0.0;
    /// Σ t³ − t over groups of t equal magnitudes.
    double tieCorrection = 0.0;
};

/// Equal magnitudes share the mean of their ranks.
RankSum rankSumOf(const std::vector<double>& differences) {
    std::vector<std::size_t> order(differences.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto magnitude = [&](std::size_t i) { return std::abs(differences[i]); };
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return magnitude(a) < magnitude(b); });
    RankSum result;
    for (std::size_t first = 0; first < order.size();) {
        std::size_t last = first;
        while (last + 1 < order.size() && magnitude(order[last + 1]) == magnitude(order[first]))
            ++last;
        const double rank = 0.5 * static_cast<double>(first + last) + 1.0;
        for (std::size_t i = first; i <= last; ++i)
            if (differences[order[i]] > 0.0) result.positive += rank;
        const auto tied = static_cast<double>(last - first + 1);
        result.tieCorrection += tied * (tied * tied - 1.0);
        first = last + 1;
    }
    return result;
}

/// Probability of each sum of ranks when every sign is as likely as the other.
std::vector<double> rankSumDistribution(std::size_t count) {
    std::vector<double> distribution = {1.0};
    for (std::size_t rank = 1; rank <= count; ++rank) {
        std::vector<double> next(distribution.size() + rank, 0.0);
        for (std::size_t sum = 0; sum < distribution.size(); ++sum) {
            next[sum] += 0.5 * distribution[sum];
            next[sum + rank] += 0.5 * distribution[sum];
        }
        distribution = std::move(next);
    }
    return distribution;
}

void testExactly(const RankSum& sum, std::size_t count, WilcoxonResult& result) {
    const std::vector<double> distribution = rankSumDistribution(count);
    const auto at = static_cast<std::ptrdiff_t>(sum.positive);
    const auto total = [](auto first, auto last) { return std::clamp(std::accumulate(first, last, 0.0), 0.0, 1.0); };
    result.less = total(distribution.begin(), distribution.begin() + at + 1);
    result.greater = total(distribution.begin() + at, distribution.end());
}

void testByNormal(const RankSum& sum, std::size_t pairs, WilcoxonResult& result) {
    const auto count = static_cast<double>(pairs);
    const double mean = 0.25 * count * (count + 1.0);
    const double variance = (count * (count + 1.0) * (2.0 * count + 1.0) - 0.5 * sum.tieCorrection) / 24.0;
    const double z = (sum.positive - mean) / std::sqrt(variance);
    const auto cumulative = [](double value) { return 0.5 * std::erfc(-value / std::numbers::sqrt2); };
    result.less = cumulative(z);
    result.greater = cumulative(-z);
}

}  // namespace

WilcoxonResult wilcoxonSignedRank(std::span<const double> differences) {
    std::vector<double> differing;
    for (const double difference : differences) {
        if (!std::isfinite(difference))
            throw Error("signed-rank test", "a difference is not finite", "leave out pairs without a number");
        if (difference != 0.0) differing.push_back(difference);
    }
    WilcoxonResult result;
    result.pairs = differences.size();
    result.zeros = differences.size() - differing.size();
    const bool exact = result.zeros == 0 && result.pairs <= kMostExactPairs;
    result.method = exact ? WilcoxonMethod::Exact : WilcoxonMethod::Normal;
    if (differing.empty()) return result;
    const RankSum sum = rankSumOf(differing);
    result.statistic = sum.positive;
    if (exact)
        testExactly(sum, differing.size(), result);
    else
        testByNormal(sum, differing.size(), result);
    return result;
}

}  // namespace fodscope
