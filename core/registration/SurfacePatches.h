// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/common/Progress.h"
#include "core/registration/NeighbourGraph.h"

namespace fodscope {

/// Voxel means on a lattice that starts half a voxel below the least coordinates (Open3D's).
std::vector<Eigen::Vector3d> voxelMeans(std::span<const Eigen::Vector3d> points, double voxelSize_m);

/// A small piece of surface: the plane through the voxels round one voxel of a cloud.
struct SurfacePatch {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    /// Unit length, of either sense: a cloud does not tell which side is inside.
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    /// 0 where the voxels show no plane (edges, rods, scattered points), 1 in the middle of a smooth one.
    double planarity = 0.0;
};

/// A cloud as pieces of surface, with the search over their centres.
class SurfacePatches {
  public:
    /// @param points the cloud, in its own frame
    /// @param voxelSize_m edge of the voxels whose means become the centres
    /// @throws Error when there are no points
    SurfacePatches(std::span<const Eigen::Vector3d> points, double voxelSize_m, Progress& progress);

    std::span<const SurfacePatch> all() const { return patches_; }
    std::size_t size() const { return patches_.size(); }
    /// The search over the voxel means; a patch's centre is its voxel's mean moved onto its plane.
    const NeighbourGraph& places() const { return graph_; }
    double voxelSize_m() const { return voxelSize_m_; }

    /// A share of the patches in which no direction of the surfaces has much more than its part, so that a large flat
    /// floor does not outvote the walls. Source: Rusinkiewicz and Levoy 2001 (normal-space sampling). Deterministic.
    /// @return indices of planar patches, ascending, about `count` at most
    std::vector<std::uint32_t> balancedSample(std::size_t count) const;

  private:
    double voxelSize_m_;
    std::vector<Eigen::Vector3d> places_;
    NeighbourGraph graph_;
    std::vector<SurfacePatch> patches_;
};

}  // namespace fodscope
