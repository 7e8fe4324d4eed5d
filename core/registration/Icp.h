// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>

#include "core/cloud/NeighbourIndex.h"
#include "core/common/Geometry.h"
#include "core/common/Progress.h"

namespace fodscope {

/// The target of an alignment: its points and the search over them, which must both outlive it.
struct IcpTarget {
    std::span<const Eigen::Vector3d> points;
    const NeighbourIndex& index;
};

struct IcpSettings {
    /// Pairs farther apart are ignored.
    double maximumCorrespondence_m = 0.5;
    int maximumIterations = 200;
    /// The search has settled when a step changes neither the share of paired points nor the root mean square distance
    /// of the pairs (metres) by this much. Source: Open3D's ICPConvergenceCriteria.
    double tolerance = 1e-6;
};

struct IcpResult {
    Transform T_target_from_source = Transform::Identity();
    bool converged = false;
    int iterations = 0;
};

/// Point-to-point ICP: nearest target point of every source point, least-squares rigid motion of the pairs (SVD),
/// again. Sums run in the order of the points, so the result does not depend on the number of threads.
IcpResult icp(std::span<const Eigen::Vector3d> source, const IcpTarget& target, const Transform& start,
              const IcpSettings& settings, const std::string& stage, Progress& progress);

/// Least-squares rigid motion that takes `from[i]` to `to[i]`. Source: Kabsch; Umeyama without scale.
Transform rigidMotion(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to);

}  // namespace fodscope
