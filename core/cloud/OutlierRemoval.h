// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/cloud/PointCloud.h"
#include "core/common/Progress.h"

namespace fodscope {

struct OutlierRemovalSettings {
    bool enabled = true;
    /// Nearest points whose mean distance is judged, the point itself (distance 0) among them (Open3D's rule).
    int neighbours = 50;
    /// A point is kept when its mean distance is under mean + this many standard deviations over all points.
    double standardDeviations = 2.0;

    bool operator==(const OutlierRemovalSettings&) const = default;
};

/// Statistical outlier removal. Standard deviation with n − 1. Source: Open3D `remove_statistical_outlier`.
/// @param stage what the progress is reported as
/// @return the indices of the points kept, ascending
/// @throws Error for settings that are not positive
std::vector<std::uint32_t> keptByOutlierRemoval(std::span<const Eigen::Vector3d> points,
                                                const OutlierRemovalSettings& settings, Progress& progress,
                                                const std::string& stage = "removing outliers");

/// @return the points (and colours) at the indices
PointCloud select(const PointCloud& cloud, std::span<const std::uint32_t> indices);

/// Leaves the cloud only the points (and colours) at the ascending indices, without a second cloud in memory.
void keepOnly(PointCloud& cloud, std::span<const std::uint32_t> indices);

}  // namespace fodscope
