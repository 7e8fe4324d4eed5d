// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace fodscope {

/// What the space is known to look like without FOD: points with, where nominal maps were there, local covariances.
/// Paper: "Reference Point Cloud Generation" and "Covariance Fitting". All vectors are empty or have one entry a point.
struct ReferenceMap {
    /// Metres, reference frame (z up).
    std::vector<Eigen::Vector3d> points;
    /// Points of the nominal maps in this point's voxel.
    std::vector<std::int32_t> occupancy;
    /// n_i: samples whose nearest reference point this is.
    std::vector<std::int32_t> sampleCount;
    /// S_i: scatter of those samples about the point, m² (paper eq. "scatter"). Not stored in a reference file.
    std::vector<Eigen::Matrix3d> scatter;
    /// Σ_i: smoothed covariance, m².
    std::vector<Eigen::Matrix3d> covariance;
    /// 1 where the samples do not support a covariance (none, or none out of one plane); such a point gives no
    /// Mahalanobis discrepancy.
    std::vector<std::uint8_t> untrained;
    /// How it was made, one line each; kept as comments in the file.
    std::vector<std::string> provenance;

    std::size_t size() const { return points.size(); }
    bool hasCovariance() const { return !covariance.empty(); }
};

}  // namespace fodscope
