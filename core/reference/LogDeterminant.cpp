// SPDX-License-Identifier: MIT
#include "core/reference/LogDeterminant.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>

#include "core/common/Quantile.h"
#include "core/reference/Covariance.h"

namespace fodscope {

std::vector<double> logDeterminants(const ReferenceMap& reference) {
    std::vector<double> values(reference.covariance.size(), std::numeric_limits<double>::quiet_NaN());
    const bool isJudged = reference.untrained.size() == values.size();
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!isJudged) {
            values[i] = logDeterminant(reference.covariance[i]);
        } else if (reference.untrained[i] == 0) {
            // Known to be invertible, so its eigenvalues need not be looked at again: a window waits for this.
            const Eigen::LLT<Eigen::Matrix3d> factor(reference.covariance[i]);
            if (factor.info() == Eigen::Success)
                values[i] = 2.0 * Eigen::Matrix3d(factor.matrixL()).diagonal().array().log().sum();
        }
    }
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
