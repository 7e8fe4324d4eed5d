// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/detection/Discrepancy.h"
#include "core/reference/ReferenceMap.h"

namespace fodscope {

struct CoverageSettings {
    /// A reference point is observed when a voxel of the map lies within this distance.
    double observedWithin_m = 0.10;

    bool operator==(const CoverageSettings&) const = default;
};

/// What of the reference was seen by the map, judged by point density alone: no sensor rays are used, and whoever shows
/// the figures must say so.
struct Coverage {
    /// 1 for each reference point that was observed.
    std::vector<std::uint8_t> observed;
    /// Share of the reference points that were observed, 0..1.
    double observedShare = 0.0;
    /// Reference points that the crop height left out of the judgement.
    std::size_t leftOut = 0;
};

Coverage measureCoverage(const ReferenceMap& reference, const DiscrepancyField& field,
                         const DiscrepancySettings& discrepancy, const CoverageSettings& settings, Progress& progress);

}  // namespace fodscope
