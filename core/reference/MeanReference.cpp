// SPDX-License-Identifier: MIT
#include "core/reference/MeanReference.h"

#include <cmath>
#include <sstream>
#include <string>

#include "core/cloud/VoxelGrid.h"
#include "core/common/Error.h"
#include "core/common/Quantile.h"

namespace fodscope {
namespace {

void check(const MeanReferenceSettings& settings) {
    if (!(settings.voxelSize_m > 0.0) || !std::isfinite(settings.voxelSize_m)) {
        throw Error("reference voxel", "must be greater than 0", "give a length in metres such as 0.05");
    }
    if (!(settings.occupancyQuantile >= 0.0 && settings.occupancyQuantile <= 1.0)) {
        throw Error("occupancy quantile", "must lie between 0 and 1", "give for example 0.25");
    }
    requireUsable(settings.covariance);
}

void keepOccupiedVoxels(const VoxelCloud& voxels, double quantile, ReferenceMap& reference) {
    const double least = quantileOf(voxels.weights, quantile);
    for (std::size_t i = 0; i < voxels.size(); ++i) {
        if (static_cast<double>(voxels.weights[i]) < least) continue;
        reference.points.push_back(voxels.points[i]);
        reference.occupancy.push_back(static_cast<std::int32_t>(voxels.weights[i]));
    }
}

std::vector<std::string> provenanceOf(std::size_t mapCount, const MeanReferenceSettings& settings) {
    std::ostringstream grid;
    grid << "voxel_m " << settings.voxelSize_m << " occupancy_quantile " << settings.occupancyQuantile << " "
         << provenanceOf(settings.covariance);
    return {"Fodscope mean reference map of " + std::to_string(mapCount) + " nominal maps",
            provenanceOf(settings.denoise), grid.str()};
}

}  // namespace

ReferenceMap meanReference(std::span<const AlignedNominalMap> maps, const MeanReferenceSettings& settings,
                           Progress& progress) {
    check(settings);
    const std::vector<Eigen::Vector3d> samples = samplesOf(maps, settings.denoise, progress);
    const Eigen::Vector3d origin = minimumCorner(samples).array() - 0.5 * settings.voxelSize_m;
    progress.report("merging the nominal maps", 0.0);
    const VoxelCloud voxels = voxelGrid(samples, origin, {settings.voxelSize_m});
    ReferenceMap reference;
    keepOccupiedVoxels(voxels, settings.occupancyQuantile, reference);
    collectScatter(samples, reference, progress);
    fitCovariances(reference, settings.covariance, progress);
    reference.provenance = provenanceOf(maps.size(), settings);
    return reference;
}

}  // namespace fodscope
