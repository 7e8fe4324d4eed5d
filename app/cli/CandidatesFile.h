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

/// Gives the targets their voxels from the `discrepancy.ply` beside the file. Where that is missing, each is taken for
/// a box as wide as it is long.
/// @return the points that no line of sight may be blocked by: all voxels above the threshold, or without that file the
///         discs that the candidates cover
/// @throws Error for a `discrepancy.ply` that cannot be read
std::vector<Eigen::Vector3d> addVoxels(CandidatesFile& candidates, const std::filesystem::path& file);

}  // namespace fodscope::cli
