// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/common/Geometry.h"
#include "core/common/Progress.h"
#include "core/registration/PoseUncertainty.h"

namespace fodscope {

/// What the last step of an alignment makes least.
enum class Refinement {
    PointToPlane,  ///< distances to the planes of the reference, robustly: nearest to where the robot was
    PointToPoint   ///< the paper: squared distances to the nearest reference points, which are what the discrepancy is
};

struct RegistrationSettings {
    /// Voxels of the map by which overlap and residual are told, and that are fitted point to point.
    double mapVoxelSize_m = 0.02;
    /// Paper's robot: correspondences farther apart are ignored ("ICP threshold").
    double maximumCorrespondence_m = 0.5;
    int maximumIterations = 200;
    /// A map voxel within this distance of the reference counts as overlapping.
    double overlapDistance_m = 0.05;
    /// Alignments with a smaller share of overlapping map voxels are bad, and no candidates are claimed from them.
    double minimumOverlap = 0.6;
    /// Voxels whose surfaces are searched and fitted.
    double coarseVoxelSize_m = 0.05;
    /// Share of the map's surfaces, every direction counting alike, that have to lie in surfaces of the reference. A
    /// floor on a floor overlaps at any yaw, but its walls then lie in nothing.
    double minimumExplained = 0.5;
    /// Another pose that explains at least the best pose's share less this fits nearly as well: nobody but the operator
    /// can tell which is true.
    double ambiguityMargin = 0.05;
    /// A map whose parts do not lie rightly to each other has no one true pose: point to plane fits most of it well and
    /// a part badly, point to point spreads the misfit, and thresholds that are chosen for one suit the other less.
    Refinement refinement = Refinement::PointToPoint;

    bool operator==(const RegistrationSettings&) const = default;
};

enum class RegistrationQuality {
    Given,      ///< the transform was given by the user; nothing was searched
    Good,       ///< converged, and it fits as no other pose does
    Ambiguous,  ///< the map does not tell which of some poses is true: no candidates are claimed, a start pose decides
    Bad         ///< not converged or too little overlap: no candidates are claimed
};

/// @return whether candidates may be claimed from an alignment of this quality
constexpr bool isTrusted(RegistrationQuality quality) {
    return quality == RegistrationQuality::Given || quality == RegistrationQuality::Good;
}

/// Another pose that fits nearly as well as the best one.
struct PoseAlternative {
    Transform T_reference_from_map = Transform::Identity();
    double rms_m = 0.0;
    double overlap = 0.0;
    double explained = 0.0;
};

struct RegistrationResult {
    /// The pose; when the quality is Bad merely the best that was tried, and not to be used.
    Transform T_reference_from_map = Transform::Identity();
    RegistrationQuality quality = RegistrationQuality::Bad;
    /// Empty when the transform was given.
    std::optional<bool> converged;
    /// Root mean square distance of the overlapping map voxels to the reference.
    double rms_m = 0.0;
    /// Share of map voxels within overlapDistance_m of the reference.
    double overlap = 0.0;
    /// Share of the map's surfaces, every direction counting alike, that lie in surfaces of the reference.
    double explained = 0.0;
    /// One sentence for the operator, e.g. "aligned, 8 mm rms, 94 % overlap, known to 3 mm and 0.1°".
    std::string summary;
    /// Other poses that fit nearly as well, the best first. To choose one, or T_reference_from_map itself, register
    /// again with it as the start pose.
    std::vector<PoseAlternative> alternatives;
    /// Empty when the map could not be fitted.
    std::optional<PoseUncertainty> uncertainty;
    /// The start pose that was given, kept so that a reopened session sets out from it again.
    std::optional<Transform> start_T_reference_from_map;
};

/// Aligns a denoised map with the reference. With a start pose by point-to-plane ICP from there, refined point to point
/// where the settings say so; without one from a search over all yaws and places (the map's z axis leans by a few
/// degrees at most), which also tells whether another pose fits nearly as well. A start pose that leads nowhere is not
/// overruled in silence: when the map fits elsewhere, the result is Ambiguous. A failure is Bad, never identity passed
/// off as a result.
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
