// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/reference/ReferenceMap.h"

namespace fodscope {

/// @return natural logarithm of each covariance's determinant (m² to the third), NaN at untrained points; empty when
///         the reference has no covariances
std::vector<double> logDeterminants(const ReferenceMap& reference);

struct HeatMapRange {
    double low = 0.0;
    double high = 0.0;

    bool operator==(const HeatMapRange&) const = default;
};

/// The range that a heat map of these values is clamped to. Paper: "the minimum value clamped to 10th percentile and
/// the maximum value clamped to 90th percentile" (numpy.percentile's interpolation).
/// @param values NaN where nothing is known, which does not count
/// @return empty when no value is known
std::optional<HeatMapRange> heatMapRange(std::span<const double> values);

}  // namespace fodscope
