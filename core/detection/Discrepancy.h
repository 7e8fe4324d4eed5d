// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/cloud/Smoothing.h"
#include "core/common/Geometry.h"
#include "core/common/Progress.h"
#include "core/detection/LocalStatisticalTest.h"
#include "core/reference/ReferenceMap.h"

namespace fodscope {

/// `Euclidean` in metres, `Mahalanobis` and `ChiSquare` (see LocalStatisticalTest.h) unitless.
enum class Metric { Euclidean, Mahalanobis, ChiSquare };

/// How the map is thinned before it is compared.
enum class DownSampling {
    Voxel,  ///< mean and count of the points in each voxel
    Random  ///< a share of the points, each with weight 1
};

struct DiscrepancySettings {
    DownSampling downSampling = DownSampling::Voxel;
    /// Paper: voxel size of the query, 0.02 m. With random down-sampling the size that a kept point is taken to have
    /// where a candidate is measured and drawn.
    double voxelSize_m = 0.02;
    /// Share of the points that random down-sampling keeps. Paper's simulation: 0.1.
    double randomRatio = 0.1;
    /// The same map, ratio and seed keep the same points.
    int randomSeed = 1;
    /// Keep only points inside the reference's bounds (authors' published code).
    bool cropToReference = true;
    /// Points higher than this in the reference frame are dropped; empty: no limit.
    std::optional<double> cropHeight_m;
    /// Paper: mean over the k = 50 nearest. A single neighbour means no smoothing.
    SmoothingSettings smoothing;
    /// How often it is smoothed; 0: not at all.
    int smoothingPasses = 1;

    bool operator==(const DiscrepancySettings&) const = default;
};

/// The map thinned ("voxels", also when it was thinned at random), with how far each deviates from the reference. One
/// entry a voxel in every vector; the Mahalanobis vectors are empty when the reference has no covariances.
struct DiscrepancyField {
    /// Voxel means, or the points kept at random, reference frame, metres.
    std::vector<Eigen::Vector3d> points;
    /// n_i: map points in the voxel; 1 when kept at random.
    std::vector<std::uint32_t> weights;
    /// Index of the nearest reference point.
    std::vector<std::uint32_t> nearest;
    /// Distance to it, metres.
    std::vector<double> euclidean_m;
    /// Local Mahalanobis distance (paper eq. "M-dist_local"); NaN at reference points that are untrained.
    std::vector<double> mahalanobis;
    /// The two smoothed over each voxel's neighbourhood, Σ w_j n_j d_j / Σ w_j n_j over those that are known; NaN where
    /// none is.
    std::vector<double> smoothedEuclidean_m;
    std::vector<double> smoothedMahalanobis;
    /// Local statistical test of euclidean_m; empty until withChiSquare() was asked for it.
    std::vector<double> chiSquare;

    std::size_t size() const { return points.size(); }
    bool hasMahalanobis() const { return !mahalanobis.empty(); }
    bool has(Metric metric) const;
    /// What the threshold is compared with. The χ² distance is that of a neighbourhood already and is not smoothed
    /// again: its p-value would no longer hold.
    /// @throws Error when Mahalanobis is asked for and the reference had no covariances, or the χ² distance before
    ///         withChiSquare()
    const std::vector<double>& smoothed(Metric metric) const;
};

/// Crop, down-sampling, nearest reference point, L2 and local Mahalanobis discrepancy, smoothing weighted by point
/// counts. Paper: "Discrepancy Query".
/// @param map denoised points, map frame
/// @throws Error when no point is left after the crop, or a setting is out of range; Cancelled
DiscrepancyField measureDiscrepancy(std::span<const Eigen::Vector3d> map, const Transform& T_reference_from_map,
                                    const ReferenceMap& reference, const DiscrepancySettings& settings,
                                    Progress& progress);

/// The field with the local statistical test of its Euclidean discrepancy.
/// @throws Error for settings out of range or a discrepancy that is the same everywhere; Cancelled
DiscrepancyField withChiSquare(const DiscrepancyField& field, const LocalStatisticalTestSettings& settings,
                               Progress& progress);

}  // namespace fodscope
