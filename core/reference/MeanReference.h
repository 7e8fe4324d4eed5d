// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "core/cloud/OutlierRemoval.h"
#include "core/common/Progress.h"
#include "core/reference/CovarianceFit.h"
#include "core/reference/NominalMaps.h"
#include "core/reference/ReferenceMap.h"

namespace fodscope {

struct MeanReferenceSettings {
    /// Paper: statistical outlier removal of every nominal map.
    OutlierRemovalSettings denoise;
    /// Paper: voxel size of the mean point cloud, 0.05 m.
    double voxelSize_m = 0.05;
    /// Paper: voxels with fewer points than this quantile of the counts are dropped (25th percentile).
    double occupancyQuantile = 0.25;
    CovarianceFitSettings covariance;

    bool operator==(const MeanReferenceSettings&) const = default;
};

/// Mean reference from nominal maps: denoise, move, merge, voxel mean, drop voxels under the occupancy quantile,
/// scatter of every sample about its nearest reference point, covariances (see fitCovariances()).
/// The lattice starts half a voxel below the least coordinate of the merged points (Open3D's origin).
/// @throws Error for no maps, settings out of range, or when nothing is left
ReferenceMap meanReference(std::span<const AlignedNominalMap> maps, const MeanReferenceSettings& settings,
                           Progress& progress);

}  // namespace fodscope
