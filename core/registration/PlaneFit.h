// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/common/Geometry.h"
#include "core/common/Progress.h"
#include "core/registration/NeighbourGraph.h"
#include "core/registration/PoseUncertainty.h"
#include "core/registration/SurfacePatches.h"

namespace fodscope {

struct PlaneFitSettings {
    /// Pairs farther apart are ignored.
    double maximumCorrespondence_m = 0.5;
    int maximumIterations = 200;
    /// Settled when a step moves no part of the map by more than this.
    double tolerance_m = 1e-5;
    /// The limit of the residuals shrinks with every step down to what they warrant, and begins here or at the largest
    /// correspondence. From near the solution it may begin low.
    double firstLimit_m = std::numeric_limits<double>::infinity();
};

struct PlaneFit {
    Transform T_target_from_source = Transform::Identity();
    bool converged = false;
    int iterations = 0;
    /// Of the last step; empty when it had too few pairs.
    std::optional<PoseUncertainty> uncertainty;
};

/// Some patches of a source and the target patch nearest to each, at one pose after another. Poses that lie near each
/// other cost little after the first one.
class PatchPairs {
  public:
    /// @param chosen the source patches to use; all must outlive this
    PatchPairs(const SurfacePatches& source, std::span<const std::uint32_t> chosen, const SurfacePatches& target)
        : source_(source), chosen_(chosen), target_(target), centres_(chosen.size()) {}

    void moveTo(const Transform& T_target_from_source, Progress& progress);

    std::size_t size() const { return chosen_.size(); }
    const SurfacePatches& target() const { return target_; }
    const SurfacePatch& sourcePatch(std::size_t pair) const { return source_.all()[chosen_[pair]]; }
    const SurfacePatch& targetPatch(std::size_t pair) const { return target_.all()[pairs_[pair].index]; }
    /// The source patch's centre at the present pose, target frame.
    const Eigen::Vector3d& centre(std::size_t pair) const { return centres_[pair]; }
    double squaredDistance_m2(std::size_t pair) const { return pairs_[pair].squaredDistance_m2; }

  private:
    const SurfacePatches& source_;
    std::span<const std::uint32_t> chosen_;
    const SurfacePatches& target_;
    std::vector<Eigen::Vector3d> centres_;
    std::vector<Neighbour> pairs_;
};

/// Point-to-plane ICP: every patch of the source goes to the plane of the nearest target patch whose normal agrees,
/// with Tukey weights from the residuals' own scale. Distances along the surface do not count, so two voxel lattices do
/// not lock on each other. Directions that the pairs do not hold are left as they are at the start (Zhang, Kaess, Singh
/// 2016). The number of threads does not change the result.
PlaneFit fitToPlanes(PatchPairs& pairs, const Transform& start, const PlaneFitSettings& settings,
                     const std::string& stage, Progress& progress);

/// The share of the pairs whose surfaces are one at a pose.
/// @param tolerance_m how far from the target's plane a patch may lie
double explainedShare(PatchPairs& pairs, const Transform& T_target_from_source, double tolerance_m, Progress& progress);

}  // namespace fodscope
