// SPDX-License-Identifier: MIT
#include "core/coverage/Coverage.h"

#include <cmath>

#include "core/cloud/NeighbourIndex.h"
#include "core/common/Error.h"

namespace fodscope {

Coverage measureCoverage(const ReferenceMap& reference, const DiscrepancyField& field,
                         const DiscrepancySettings& discrepancy, const CoverageSettings& settings, Progress& progress) {
    if (!(settings.observedWithin_m > 0.0) || !std::isfinite(settings.observedWithin_m)) {
        throw Error("coverage distance", "must be greater than 0", "give a length in metres such as 0.1");
    }
    Coverage coverage;
    coverage.observed.assign(reference.size(), 0);
    if (field.size() == 0) return coverage;

    const NeighbourIndex voxels(field.points, progress);
    const std::vector<Neighbour> nearest = voxels.nearestOfEach(reference.points, progress, "measuring the coverage");
    std::size_t observed = 0;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        if (discrepancy.cropHeight_m && reference.points[i].z() >= *discrepancy.cropHeight_m) {
            ++coverage.leftOut;
            continue;
        }
        if (std::sqrt(nearest[i].squaredDistance_m2) > settings.observedWithin_m) continue;
        coverage.observed[i] = 1;
        ++observed;
    }
    const std::size_t judged = reference.size() - coverage.leftOut;
    if (judged > 0) coverage.observedShare = static_cast<double>(observed) / static_cast<double>(judged);
    return coverage;
}

}  // namespace fodscope
