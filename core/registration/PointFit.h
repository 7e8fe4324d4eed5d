// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>

#include "core/cloud/NeighbourIndex.h"
#include "core/common/Geometry.h"
#include "core/common/Progress.h"

namespace fodscope {

struct PointFitSettings {
    /// Pairs farther apart are ignored. Paper's robot: 0.5 m.
    double maximumCorrespondence_m = 0.5;
    int maximumIterations = 200;
    /// It has settled when a step changes neither the share of paired points nor the root mean square distance of the
    /// pairs (metres) by this much. Source: Open3D's ICPConvergenceCriteria.
    double tolerance = 1e-6;
};

struct PointFit {
    Transform T_target_from_source = Transform::Identity();
    bool converged = false;
};

/// Point-to-point ICP, the paper's registration: the nearest target point of every source point, the least-squares
/// rigid motion of the pairs, again. It must begin near the solution. What it makes least is what the discrepancy
/// measures, the distances to the nearest reference points; the price is that equal lattices lock on each other, so the
/// source's voxels must be finer than the target's. The result does not depend on the number of threads.
/// @param target the points that `index` searches
PointFit fitToPoints(std::span<const Eigen::Vector3d> source, std::span<const Eigen::Vector3d> target,
                     const NeighbourIndex& index, const Transform& start, const PointFitSettings& settings,
                     const std::string& stage, Progress& progress);

}  // namespace fodscope
