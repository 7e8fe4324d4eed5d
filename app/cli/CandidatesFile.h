// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/common/Geometry.h"
#include "core/planning/Waypoints.h"

namespace fodscope::cli {

/// What planning needs of a `candidates.json`.
struct CandidatesFile {
    std::vector<PlanTarget> targets;
    Transform T_reference_from_map = Transform::Identity();
    double threshold = 0.0;
    /// Empty without candidates: the file tells the floor through their heights.
    std::optional<double> floorHeight_m;
};

/// @throws Error naming the file when it is no candidates file
CandidatesFile readCandidatesFile(const std::filesystem::path& file);

/// The points that no line of sight may be blocked by: all voxels above the threshold in the `discrepancy.ply` beside
/// the file, or where that is missing the discs that the candidates cover.
/// @throws Error for a `discrepancy.ply` that cannot be read
std::vector<Eigen::Vector3d> discrepantPoints_map(const CandidatesFile& candidates, const std::filesystem::path& file);

}  // namespace fodscope::cli
