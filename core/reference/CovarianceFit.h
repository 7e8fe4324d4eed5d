// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/cloud/Smoothing.h"
#include "core/common/Progress.h"
#include "core/reference/ReferenceMap.h"

namespace fodscope {

/// How local covariances are made of the samples' scatter. Paper: "Covariance Fitting".
struct CovarianceFitSettings {
    /// Paper: mean over the k = 250 nearest reference points (physical trials); Gaussian with σ = 0.05 m in a ball of
    /// 4 σ (simulation).
    SmoothingSettings smoothing{.neighbours = 250};
    /// Smooth only at the means of voxels of this edge, and give every reference point the covariance of the nearest
    /// of them. Empty: smooth at every reference point.
    std::optional<double> smoothingVoxelSize_m;
    /// λ in m²: λ I is added to every fitted covariance, so that a plane without extent across it gets one (authors'
    /// published code: regularize). 0: nothing is added, and where the samples do not span space it is untrained.
    double regularisation_m2 = 0.0;

    bool operator==(const CovarianceFitSettings&) const = default;
};

/// @return what is wrong with the settings, one sentence each
std::vector<std::string> covarianceFitProblems(const CovarianceFitSettings& settings);

/// @throws Error that lists those problems
void requireUsable(const CovarianceFitSettings& settings);

/// n_i and S_i = Σ Δx Δxᵀ of the samples about their nearest reference point (paper eq. "scatter"). Replaces what the
/// reference held.
/// @param samples points of nominal maps in the reference frame
/// @throws Error when the reference has no points, or a coordinate is not finite; Cancelled
void collectScatter(std::span<const Eigen::Vector3d> samples, ReferenceMap& reference, Progress& progress);

/// Σ_i from the scatter of the reference points in its neighbourhood, itself included:
///   mean      Σ S_j / Σ n_j
///   Gaussian  Σ w_j S_j / (V1 − V2 / V1) with V1 = Σ n_j w_j and V2 = Σ n_j w_j² (reliability weights, unbiased)
/// A point is marked untrained, with a NaN covariance, when its neighbourhood has no sample; when V1 − V2 / V1 is 0,
/// as with a single sample; when all of its weights are 0 in double precision; and when the covariance, λ I included,
/// has no inverse (isInvertible()).
///
/// With `smoothingVoxelSize_m` only the places of evaluation are thinned: the neighbourhood of a voxel's mean is made
/// of the full reference's points, whose scatter is about themselves. So every sample still counts at its nearest
/// reference point, from which the discrepancy is measured later, and k keeps its meaning. The paper leaves this open;
/// the authors' published code does the same.
/// @throws Error for settings out of range, all told at once, or a reference without scatter; Cancelled
void fitCovariances(ReferenceMap& reference, const CovarianceFitSettings& settings, Progress& progress);

/// @return the settings in the words of a reference's provenance
std::string provenanceOf(const CovarianceFitSettings& settings);

}  // namespace fodscope
