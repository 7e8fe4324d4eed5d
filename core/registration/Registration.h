// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>

#include "core/common/Geometry.h"
#include "core/common/Progress.h"

namespace fodscope {

struct RegistrationSettings {
    /// Voxels of the map that is aligned. Point-to-point ICP of equal lattices locks on the lattice, so this is smaller
    /// than the reference's voxel.
    double mapVoxelSize_m = 0.02;
    /// Paper's robot: correspondences farther apart are ignored ("ICP threshold").
    double maximumCorrespondence_m = 0.5;
    int maximumIterations = 200;
    /// A map voxel within this distance of the reference counts as overlapping.
    double overlapDistance_m = 0.05;
    /// Alignments with a smaller share of overlapping map voxels are bad, and no candidates are claimed from them.
    double minimumOverlap = 0.6;
    /// Voxels of the coarse search (FPFH features) that runs when the start pose does not lead to a good alignment.
    double coarseVoxelSize_m = 0.10;

    bool operator==(const RegistrationSettings&) const = default;
};

enum class RegistrationQuality {
    Given,  ///< the transform was given by the user; nothing was searched
    Good,   ///< converged, and the overlap is sufficient
    Bad     ///< not converged or too little overlap: no candidates are claimed
};

struct RegistrationResult {
    Transform T_reference_from_map = Transform::Identity();
    RegistrationQuality quality = RegistrationQuality::Bad;
    /// Empty when the transform was given.
    std::optional<bool> converged;
    /// Root mean square distance of the overlapping map voxels to the reference.
    double rms_m = 0.0;
    /// Share of map voxels within overlapDistance_m of the reference.
    double overlap = 0.0;
    /// One sentence for the operator, e.g. "aligned, 8 mm rms, 94 % overlap".
    std::string summary;
};

/// Aligns a denoised map with the reference: from the start pose (identity unless given) by ICP, and when that ends
/// badly once more from a coarse feature match (FPFH, PCL). A failure is Bad, never identity passed off as a result.
/// @param map points in the map frame
/// @param reference points in the reference frame
/// @throws Error when either is empty; Cancelled
RegistrationResult registerMap(std::span<const Eigen::Vector3d> map, std::span<const Eigen::Vector3d> reference,
                               const std::optional<Transform>& start_T_reference_from_map,
                               const RegistrationSettings& settings, Progress& progress);

/// Judges a given transform by the same measures; its quality is Given and `converged` stays empty.
RegistrationResult judgeTransform(std::span<const Eigen::Vector3d> map, std::span<const Eigen::Vector3d> reference,
                                  const Transform& T_reference_from_map, const RegistrationSettings& settings,
                                  Progress& progress);

}  // namespace fodscope
