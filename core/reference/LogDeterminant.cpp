// SPDX-License-Identifier: MIT
#include "core/reference/LogDeterminant.h"

#include <cmath>
#include <limits>

#include "core/common/Quantile.h"
#include "core/reference/Covariance.h"

namespace fodscope {

std::vector<double> logDeterminants(const ReferenceMap& reference) {
    std::vector<double> values(reference.covariance.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < values.size(); ++i)
        if (reference.untrained.empty() || reference.untrained[i] == 0)
            values[i] = logDeterminant(reference.covariance[i]);
    return values;
}

std::optional<HeatMapRange> heatMapRange(std::span<const double> values) {
    std::vector<double> known;
    for (const double value : values)
        if (std::isfinite(value)) known.push_back(value);
    if (known.empty()) return std::nullopt;
    return HeatMapRange{quantileOf(known, 0.10), quantileOf(known, 0.90)};
}

}  // namespace fodscope
