// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace fodscope {

/// numpy.quantile with its default, linear interpolation.
/// @param values at least one, none of them NaN
/// @param share 0 to 1
template <class Value>
double quantileOf(std::vector<Value> values, double share) {
    const double position = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const double part = position - static_cast<double>(below);
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(below);
    std::nth_element(values.begin(), at, values.end());
    const auto low = static_cast<double>(*at);
    if (at + 1 == values.end()) return low;
    const auto high = static_cast<double>(*std::min_element(at + 1, values.end()));
    // As numpy rounds it.
    return part < 0.5 ? low + (high - low) * part : high - (high - low) * (1.0 - part);
}

}  // namespace fodscope
