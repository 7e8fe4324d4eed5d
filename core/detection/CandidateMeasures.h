// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/detection/Candidates.h"

namespace fodscope {

/// What candidates are measured with.
struct CandidateFrame {
    double voxelSize_m = 0.02;
    double floorHeight_m = 0.0;
    Transform T_map_from_reference = Transform::Identity();
};

/// @throws Error for a threshold, cutoff, least count or voxel size out of range
void checkCandidateSettings(const CandidateSettings& settings, double voxelSize_m);

/// @return the voxels above a threshold, ascending. NaN is not above anything: what is unknown is no candidate
std::vector<std::uint32_t> voxelsAbove(const std::vector<double>& discrepancy, double threshold);

/// Everything about a candidate but its id.
/// @param discrepancy that of the field which is thresholded
/// @param voxels ascending
Candidate measuredCandidate(const DiscrepancyField& field, const std::vector<double>& discrepancy,
                            std::vector<std::uint32_t> voxels, CentroidKind centroid, const CandidateFrame& frame);

/// Most suspicious first; ids and the voxels' candidates follow that order.
void arrangeCandidates(CandidateSet& set);

}  // namespace fodscope
