// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "core/cloud/OutlierRemoval.h"
#include "core/cloud/PointCloud.h"
#include "core/common/Geometry.h"
#include "core/common/Progress.h"
#include "core/reference/ReferenceMap.h"

namespace fodscope {

struct MeanReferenceSettings {
    /// Paper: statistical outlier removal of every nominal map.
    OutlierRemovalSettings denoise;
    /// Paper: voxel size of the mean point cloud, 0.05 m.
    double voxelSize_m = 0.05;
    /// Paper: voxels with fewer points than this quantile of the counts are dropped (25th percentile).
    double occupancyQuantile = 0.25;
    /// Paper: k of the mean smoothing of the covariances, 250.
    int covarianceNeighbours = 250;

    bool operator==(const MeanReferenceSettings&) const = default;
};

/// One nominal map and where it lies: `T_reference_from_map`.
struct AlignedNominalMap {
    const PointCloud* map = nullptr;
    Transform T_reference_from_map = Transform::Identity();
    /// What keptByOutlierRemoval() gave for this map with the same settings, where it is known; null: it is done here.
    const std::vector<std::uint32_t>* kept = nullptr;
};

/// Mean reference from nominal maps: denoise, move, merge, voxel mean, drop voxels under the occupancy quantile,
/// scatter of every sample about its nearest reference point, covariances smoothed over the k nearest reference points
/// (paper eq. "scatter" and mean smoothing Σ = Σ S_j / Σ n_j).
/// The lattice starts half a voxel below the least coordinate of the merged points (Open3D's origin).
/// @throws Error for no maps, settings out of range, or when nothing is left
ReferenceMap meanReference(std::span<const AlignedNominalMap> maps, const MeanReferenceSettings& settings,
                           Progress& progress);

/// Σ_i = Σ S_j / Σ n_j over the k nearest reference points, itself included. Points whose neighbourhood has no sample,
/// or samples in one plane only, so that Σ has no inverse, are marked untrained and get a NaN covariance.
void smoothCovariances(ReferenceMap& reference, int neighbours, Progress& progress);

}  // namespace fodscope
