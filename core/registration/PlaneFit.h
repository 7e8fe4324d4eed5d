// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "core/common/Geometry.h"
#include "core/common/Progress.h"
#include "core/registration/PoseUncertainty.h"
#include "core/registration/SurfacePatches.h"

namespace fodscope {

struct PlaneFitSettings {
    /// Pairs farther apart are ignored. The limit shrinks with every step down to what the residuals warrant.
    double maximumCorrespondence_m = 0.5;
    int maximumIterations = 200;
    /// Settled when a step moves no part of the map by more than this.
    double tolerance_m = 1e-5;
};

struct PlaneFit {
    Transform T_target_from_source = Transform::Identity();
    bool converged = false;
    int iterations = 0;
    /// Of the last step; empty when it had too few pairs.
    std::optional<PoseUncertainty> uncertainty;
};

/// Point-to-plane ICP: every patch of the source goes to the plane of the nearest target patch whose normal agrees,
/// with Tukey weights from the residuals' own scale. Distances along the surface do not count, so two voxel lattices do
/// not lock on each other. Directions that the pairs do not hold are left as they are at the start (Zhang, Kaess, Singh
/// 2016). Sums run in the order of the patches: the number of threads does not change the result.
/// @param chosen the source patches to use
PlaneFit fitToPlanes(const SurfacePatches& source, std::span<const std::uint32_t> chosen, const SurfacePatches& target,
                     const Transform& start, const PlaneFitSettings& settings, const std::string& stage,
                     Progress& progress);

/// @param tolerance_m how far from the target's plane a patch may lie
double explainedShare(const SurfacePatches& source, std::span<const std::uint32_t> chosen, const SurfacePatches& target,
                      const Transform& T_target_from_source, double tolerance_m, Progress& progress);

}  // namespace fodscope
