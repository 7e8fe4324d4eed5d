// SPDX-License-Identifier: MIT
#include "core/evaluation/Numpy.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/common/Quantile.h"

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
    return quantileOf(std::move(known), percentile / 100.0);
}

}  // namespace fodscope
