// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "core/common/Geometry.h"
#include "core/common/Progress.h"
#include "core/registration/NeighbourGraph.h"

namespace fodscope {

/// Points of a source and the nearest target of each, at one pose after another. Poses that lie near each other cost
/// little after the first one.
class PointPairs {
  public:
    /// Both must outlive this.
    PointPairs(std::span<const Eigen::Vector3d> source, const NeighbourGraph& target)
        : source_(source), target_(target), moved_(source.size()) {}

    void moveTo(const Transform& T_target_from_source, Progress& progress);

    std::span<const Eigen::Vector3d> source() const { return source_; }
    std::span<const Eigen::Vector3d> target() const { return target_.points(); }
    /// The source points at the present pose, target frame.
    std::span<const Eigen::Vector3d> moved() const { return moved_; }
    std::span<const Neighbour> nearest() const { return pairs_; }

    struct Closeness {
        /// Share of the source points whose nearest target is at most that far.
        double share = 0.0;
        /// Root mean square distance of these.
        double rms_m = 0.0;
    };
    Closeness within(double maximumDistance_m) const;

  private:
    std::span<const Eigen::Vector3d> source_;
    const NeighbourGraph& target_;
    std::vector<Eigen::Vector3d> moved_;
    std::vector<Neighbour> pairs_;
};

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
/// @param pairs source and target; when it has converged, at the resulting pose
PointFit fitToPoints(PointPairs& pairs, const Transform& start, const PointFitSettings& settings,
                     const std::string& stage, Progress& progress);

}  // namespace fodscope
