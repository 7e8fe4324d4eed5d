// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace fodscope {

/// `count` evenly spaced values with both ends among them, as numpy.linspace gives them to the last bit.
std::vector<double> linearSpace(double first, double last, int count);

/// numpy.nanpercentile with linear interpolation; empty when no value is known.
std::optional<double> percentileOfKnown(std::span<const double> values, double percentile);

}  // namespace fodscope
