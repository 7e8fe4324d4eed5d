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
    std::sort(values.begin(), values.end());
    const double position = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    const double part = position - static_cast<double>(below);
    const double low = static_cast<double>(values[below]);
    return low + part * (static_cast<double>(values[above]) - low);
}

}  // namespace fodscope
