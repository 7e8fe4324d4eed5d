// SPDX-License-Identifier: MIT
#include "core/reference/MeanReference.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "core/cloud/NeighbourIndex.h"
#include "core/cloud/VoxelGrid.h"
#include "core/common/Error.h"
#include "core/reference/Covariance.h"

namespace fodscope {
namespace {

void requireNeighbours(int neighbours) {
    if (neighbours < 1) {
        throw Error("covariance neighbours", "must be at least 1, not " + std::to_string(neighbours),
                    "give a whole number such as 250");
    }
}

void check(std::span<const AlignedNominalMap> maps, const MeanReferenceSettings& settings) {
    if (maps.empty()) throw Error("reference", "no nominal maps were given", "give at least one map without FOD");
    if (!(settings.voxelSize_m > 0.0) || !std::isfinite(settings.voxelSize_m)) {
        throw Error("reference voxel", "must be greater than 0", "give a length in metres such as 0.05");
    }
    if (!(settings.occupancyQuantile >= 0.0 && settings.occupancyQuantile <= 1.0)) {
        throw Error("occupancy quantile", "must lie between 0 and 1", "give for example 0.25");
    }
    requireNeighbours(settings.covarianceNeighbours);
}

std::vector<Eigen::Vector3d> mergedSamples(std::span<const AlignedNominalMap> maps,
                                           const MeanReferenceSettings& settings, Progress& progress) {
    std::vector<Eigen::Vector3d> samples;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const std::vector<Eigen::Vector3d>& points = maps[i].map->points;
        const std::string stage =
            "denoising nominal map " + std::to_string(i + 1) + " of " + std::to_string(maps.size());
        std::vector<std::uint32_t> found;
        if (maps[i].kept == nullptr) found = keptByOutlierRemoval(points, settings.denoise, progress, stage);
        for (const std::uint32_t kept : maps[i].kept == nullptr ? found : *maps[i].kept)
            samples.push_back(maps[i].T_reference_from_map * points[kept]);
    }
    if (samples.empty()) {
        throw Error("reference", "the nominal maps hold no points after denoising", "give maps with points");
    }
    return samples;
}

/// numpy.quantile with its default, linear interpolation.
double quantileOf(std::vector<std::uint32_t> counts, double quantile) {
    std::sort(counts.begin(), counts.end());
    const double position = quantile * static_cast<double>(counts.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, counts.size() - 1);
    const double share = position - static_cast<double>(below);
    return counts[below] + share * (static_cast<double>(counts[above]) - counts[below]);
}

void keepOccupiedVoxels(const VoxelCloud& voxels, double quantile, ReferenceMap& reference) {
    const double least = quantileOf(voxels.weights, quantile);
    for (std::size_t i = 0; i < voxels.size(); ++i) {
        if (static_cast<double>(voxels.weights[i]) < least) continue;
        reference.points.push_back(voxels.points[i]);
        reference.occupancy.push_back(static_cast<std::int32_t>(voxels.weights[i]));
    }
}

/// The sums run over the samples in their order, so that they do not depend on the number of threads.
void collectScatter(std::span<const Eigen::Vector3d> samples, ReferenceMap& reference, Progress& progress) {
    reference.sampleCount.assign(reference.size(), 0);
    reference.scatter.assign(reference.size(), Eigen::Matrix3d::Zero());
    const NeighbourIndex index(reference.points);
    const std::vector<Neighbour> nearest = index.nearestOfEach(samples, progress, "collecting the scatter");
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const std::uint32_t point = nearest[i].index;
        const Eigen::Vector3d deviation = samples[i] - reference.points[point];
        reference.scatter[point] += deviation * deviation.transpose();
        ++reference.sampleCount[point];
    }
}

std::vector<std::string> provenanceOf(std::size_t mapCount, const MeanReferenceSettings& settings) {
    std::ostringstream denoise;
    if (settings.denoise.enabled) {
        denoise << "denoise neighbours " << settings.denoise.neighbours << " standard_deviations "
                << settings.denoise.standardDeviations;
    } else {
        denoise << "denoise off";
    }
    std::ostringstream grid;
    grid << "voxel_m " << settings.voxelSize_m << " occupancy_quantile " << settings.occupancyQuantile
         << " covariance_neighbours " << settings.covarianceNeighbours;
    return {"Fodscope mean reference map of " + std::to_string(mapCount) + " nominal maps", denoise.str(), grid.str()};
}

}  // namespace

ReferenceMap meanReference(std::span<const AlignedNominalMap> maps, const MeanReferenceSettings& settings,
                           Progress& progress) {
    check(maps, settings);
    const std::vector<Eigen::Vector3d> samples = mergedSamples(maps, settings, progress);
    const Eigen::Vector3d origin = minimumCorner(samples).array() - 0.5 * settings.voxelSize_m;
    progress.report("merging the nominal maps", 0.0);
    const VoxelCloud voxels = voxelGrid(samples, origin, {settings.voxelSize_m});
    ReferenceMap reference;
    keepOccupiedVoxels(voxels, settings.occupancyQuantile, reference);
    collectScatter(samples, reference, progress);
    smoothCovariances(reference, settings.covarianceNeighbours, progress);
    reference.provenance = provenanceOf(maps.size(), settings);
    return reference;
}

void smoothCovariances(ReferenceMap& reference, int neighbours, Progress& progress) {
    requireNeighbours(neighbours);
    if (reference.scatter.size() != reference.size() || reference.sampleCount.size() != reference.size()) {
        throw Error("reference", "it holds no scatter to make covariances from", "build it from nominal maps");
    }
    std::vector<Eigen::Matrix3d> covariance(reference.size(), unknownCovariance());
    std::vector<std::uint8_t> untrained(reference.size(), 1);
    if (reference.size() > 0) {
        const NeighbourIndex index(reference.points);
        index.forEachKNearest(
            reference.points, static_cast<std::size_t>(neighbours),
            [&](std::size_t i, std::span<const Neighbour> near) {
                Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
                std::int64_t samples = 0;
                for (const Neighbour& neighbour : near) {
                    scatter += reference.scatter[neighbour.index];
                    samples += reference.sampleCount[neighbour.index];
                }
                if (samples == 0) return;
                const Eigen::Matrix3d mean = scatter / static_cast<double>(samples);
                if (!isInvertible(mean)) return;
                covariance[i] = mean;
                untrained[i] = 0;
            },
            progress, "smoothing the covariances");
    }
    reference.covariance = std::move(covariance);
    reference.untrained = std::move(untrained);
}

}  // namespace fodscope
