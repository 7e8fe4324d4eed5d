// SPDX-License-Identifier: MIT
#include "core/evaluation/Numpy.h"

#include <algorithm>
#include <cmath>

namespace fodscope {

std::vector<double> linearSpace(double first, double last, int count) {
    std::vector<double> values;
    const double step = count > 1 ? (last - first) / static_cast<double>(count - 1) : 0.0;
    for (int i = 0; i < count; ++i)
        values.push_back(static_cast<double>(i) * step + first);
    if (count > 1) values.back() = last;
    return values;
}

std::optional<double> percentileOfKnown(std::span<const double> values, double percentile) {
    std::vector<double> known;
    known.reserve(values.size());
    std::ranges::copy_if(values, std::back_inserter(known), [](double value) { return !std::isnan(value); });
    if (known.empty()) return std::nullopt;
    const double position = percentile / 100.0 * static_cast<double>(known.size() - 1);
    const auto below = static_cast<std::ptrdiff_t>(std::floor(position));
    const double share = position - std::floor(position);
    std::ranges::nth_element(known, known.begin() + below);
    const double low = known[static_cast<std::size_t>(below)];
    const auto rest = known.begin() + below + 1;
    if (rest == known.end()) return low;
    const double high = *std::min_element(rest, known.end());
    // As numpy rounds it.
    return share < 0.5 ? low + (high - low) * share : high - (high - low) * (1.0 - share);
}

}  // namespace fodscope
