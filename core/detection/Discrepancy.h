// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/cloud/NeighbourIndex.h"
#include "core/common/Geometry.h"
#include "core/common/Progress.h"
#include "core/reference/ReferenceMap.h"

namespace fodscope {

/// `Euclidean` in metres, `Mahalanobis` unitless.
enum class Metric { Euclidean, Mahalanobis };

struct DiscrepancySettings {
    /// Paper: voxel size of the query, 0.02 m.
    double voxelSize_m = 0.02;
    /// Keep only points inside the reference's bounds (authors' published code).
    bool cropToReference = true;
    /// Points higher than this in the reference frame are dropped; empty: no limit.
    std::optional<double> cropHeight_m;
    /// Paper: k of the discrepancy smoothing, 50. 1 means no smoothing.
    int smoothingNeighbours = 50;

    bool operator==(const DiscrepancySettings&) const = default;
};

/// The map in voxels with how far each deviates from the reference. One entry a voxel in every vector; the Mahalanobis
/// vectors are empty when the reference has no covariances.
struct DiscrepancyField {
    /// Voxel means, reference frame, metres.
    std::vector<Eigen::Vector3d> points;
    /// n_i: map points in the voxel.
    std::vector<std::uint32_t> weights;
    /// Index of the nearest reference point.
    std::vector<std::uint32_t> nearest;
    /// Distance to it, metres.
    std::vector<double> euclidean_m;
    /// Local Mahalanobis distance (paper eq. "M-dist_local"); NaN at reference points that are untrained.
    std::vector<double> mahalanobis;
    /// The two smoothed over the k nearest voxels, Σ n_j d_j / Σ n_j; NaN where nothing is known.
    std::vector<double> smoothedEuclidean_m;
    std::vector<double> smoothedMahalanobis;

    std::size_t size() const { return points.size(); }
    bool hasMahalanobis() const { return !mahalanobis.empty(); }
    /// @throws Error when Mahalanobis is asked for and the reference had no covariances
    const std::vector<double>& smoothed(Metric metric) const;
};

/// Crop, voxel grid, nearest reference point, L2 and local Mahalanobis discrepancy, smoothing weighted by point counts.
/// Paper: "Discrepancy Query".
/// @param map denoised points, map frame
/// @throws Error when no point is left after the crop, or a setting is out of range; Cancelled
DiscrepancyField measureDiscrepancy(std::span<const Eigen::Vector3d> map, const Transform& T_reference_from_map,
                                    const ReferenceMap& reference, const DiscrepancySettings& settings,
                                    Progress& progress);

}  // namespace fodscope
