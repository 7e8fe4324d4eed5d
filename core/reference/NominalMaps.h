// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/cloud/OutlierRemoval.h"
#include "core/cloud/PointCloud.h"
#include "core/common/Geometry.h"
#include "core/common/Progress.h"

namespace fodscope {

/// One nominal map and where it lies: `T_reference_from_map`.
struct AlignedNominalMap {
    const PointCloud* map = nullptr;
    Transform T_reference_from_map = Transform::Identity();
    /// What keptByOutlierRemoval() gave for this map with the same settings, where it is known; null: it is done here.
    const std::vector<std::uint32_t>* kept = nullptr;
};

/// @return the denoised points of all maps in the reference frame: what a reference is trained with
/// @throws Error when there are no maps, no point is left of them, or one is not finite; Cancelled
std::vector<Eigen::Vector3d> samplesOf(std::span<const AlignedNominalMap> maps, const OutlierRemovalSettings& denoise,
                                       Progress& progress);

/// @throws Error when a coordinate is NaN or infinite; readers drop such points
void requireFiniteSamples(std::span<const Eigen::Vector3d> samples);

/// @return the denoising in the words of a reference's provenance
std::string provenanceOf(const OutlierRemovalSettings& denoise);

}  // namespace fodscope
