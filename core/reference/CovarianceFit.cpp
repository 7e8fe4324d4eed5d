// SPDX-License-Identifier: MIT
#include "core/reference/CovarianceFit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "core/cloud/SpatialRuns.h"
#include "core/cloud/VoxelGrid.h"
#include "core/common/Error.h"
#include "core/reference/Covariance.h"
#include "core/reference/NominalMaps.h"

namespace fodscope {
namespace {

/// Below this share of V1 the difference V1 − V2 / V1 is made of rounding errors.
constexpr double kLeastReliability = 1e-12;

/// What neighbourhoods are made of.
struct ScatteredPoints {
    std::vector<Eigen::Vector3d> points;
    std::vector<Eigen::Matrix3d> scatter;
    std::vector<std::int32_t> sampleCount;
};

/// All points of the reference for the k nearest, which are counted with those that have no sample. In a ball only
/// points with samples count, and in a CAD model many have none; their order is free there and spares the cache.
ScatteredPoints scatteredPoints(const ReferenceMap& reference, const SmoothingSettings& settings,
                                const Progress& progress) {
    if (settings.neighbourhood == SmoothingNeighbourhood::NearestNeighbours) {
        return {reference.points, reference.scatter, reference.sampleCount};
    }
    ScatteredPoints counting;
    constexpr std::size_t together = 256;
    for (const std::uint32_t i : spatialRuns(reference.points, together, progress).order) {
        if (reference.sampleCount[i] == 0) continue;
        counting.points.push_back(reference.points[i]);
        counting.scatter.push_back(reference.scatter[i]);
        counting.sampleCount.push_back(reference.sampleCount[i]);
    }
    return counting;
}

Eigen::Matrix3d meanOf(std::span<const Neighbour> near, const ScatteredPoints& from) {
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    std::int64_t samples = 0;
    for (const Neighbour& neighbour : near) {
        scatter += from.scatter[neighbour.index];
        samples += from.sampleCount[neighbour.index];
    }
    if (samples == 0) return unknownCovariance();
    return scatter / static_cast<double>(samples);
}

double leastSquaredDistanceOfSamples(std::span<const Neighbour> near, const ScatteredPoints& from) {
    double least_m2 = std::numeric_limits<double>::infinity();
    for (const Neighbour& neighbour : near)
        if (from.sampleCount[neighbour.index] > 0) least_m2 = std::min(least_m2, neighbour.squaredDistance_m2);
    return least_m2;
}

/// All weights are divided by the greatest of them, which changes nothing in Σ and keeps far ones from vanishing.
Eigen::Matrix3d gaussianOf(std::span<const Neighbour> near, const ScatteredPoints& from,
                           const SmoothingSettings& settings) {
    const double least_m2 = leastSquaredDistanceOfSamples(near, from);
    if (!(smoothingWeight(settings, least_m2) > 0.0)) return unknownCovariance();
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    double v1 = 0.0;
    double v2 = 0.0;
    for (const Neighbour& neighbour : near) {
        const double samples = from.sampleCount[neighbour.index];
        if (samples == 0.0) continue;
        const double weight = smoothingWeight(settings, neighbour.squaredDistance_m2 - least_m2);
        scatter += weight * from.scatter[neighbour.index];
        v1 += samples * weight;
        v2 += samples * weight * weight;
    }
    const double reliability = v1 - v2 / v1;
    if (!(reliability > kLeastReliability * v1)) return unknownCovariance();
    return scatter / reliability;
}

/// @return NaN where the samples support no covariance
std::vector<Eigen::Matrix3d> smoothedAt(std::span<const Eigen::Vector3d> places, const ReferenceMap& reference,
                                        const SmoothingSettings& settings, Progress& progress) {
    std::vector<Eigen::Matrix3d> smoothed(places.size(), unknownCovariance());
    const ScatteredPoints from = scatteredPoints(reference, settings, progress);
    if (from.points.empty()) return smoothed;
    const NeighbourIndex index(from.points, progress);
    const bool isMean = settings.weights == SmoothingWeights::Mean;
    forEachNeighbourhood(
        index, places, settings, "covariance smoothing",
        [&](std::size_t i, std::span<const Neighbour> near) {
            smoothed[i] = isMean ? meanOf(near, from) : gaussianOf(near, from, settings);
        },
        progress, "smoothing the covariances");
    return smoothed;
}

std::vector<Eigen::Matrix3d> smoothed(const ReferenceMap& reference, const CovarianceFitSettings& settings,
                                      Progress& progress) {
    if (!settings.smoothingVoxelSize_m) return smoothedAt(reference.points, reference, settings.smoothing, progress);
    const double voxel_m = *settings.smoothingVoxelSize_m;
    // Open3D's origin, as for the mean reference.
    const Eigen::Vector3d origin = minimumCorner(reference.points).array() - 0.5 * voxel_m;
    const std::vector<Eigen::Vector3d> places = voxelGrid(reference.points, origin, {voxel_m}).points;
    const std::vector<Eigen::Matrix3d> atPlaces = smoothedAt(places, reference, settings.smoothing, progress);
    const NeighbourIndex index(places, progress);
    std::vector<Eigen::Matrix3d> atPoints;
    atPoints.reserve(reference.size());
    for (const Neighbour& nearest : index.nearestOfEach(reference.points, progress, "spreading the covariances"))
        atPoints.push_back(atPlaces[nearest.index]);
    return atPoints;
}

}  // namespace

std::vector<std::string> covarianceFitProblems(const CovarianceFitSettings& settings) {
    std::vector<std::string> problems = smoothingProblems(settings.smoothing);
    const std::optional<double>& voxel_m = settings.smoothingVoxelSize_m;
    if (voxel_m && !(*voxel_m > 0.0 && std::isfinite(*voxel_m))) {
        problems.push_back("the smoothing voxel must be greater than 0");
    }
    if (!(settings.regularisation_m2 >= 0.0 && std::isfinite(settings.regularisation_m2))) {
        problems.push_back("the regularisation must not be negative");
    }
    return problems;
}

void requireUsable(const CovarianceFitSettings& settings) {
    std::string text;
    for (const std::string& problem : covarianceFitProblems(settings))
        text += (text.empty() ? "" : ", ") + problem;
    if (text.empty()) return;
    throw Error("covariance settings", text, "give for example 250 neighbours, or a ball of 0.2 m with sigma 0.05 m");
}

/// The sums run over the samples in their order, so that they do not depend on the number of threads.
void collectScatter(std::span<const Eigen::Vector3d> samples, ReferenceMap& reference, Progress& progress) {
    requireFiniteSamples(samples);
    reference.sampleCount.assign(reference.size(), 0);
    reference.scatter.assign(reference.size(), Eigen::Matrix3d::Zero());
    const NeighbourIndex index(reference.points, progress);
    const std::vector<Neighbour> nearest = index.nearestOfEach(samples, progress, "collecting the scatter");
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const std::uint32_t point = nearest[i].index;
        const Eigen::Vector3d deviation = samples[i] - reference.points[point];
        reference.scatter[point] += deviation * deviation.transpose();
        ++reference.sampleCount[point];
    }
}

void fitCovariances(ReferenceMap& reference, const CovarianceFitSettings& settings, Progress& progress) {
    requireUsable(settings);
    if (reference.scatter.size() != reference.size() || reference.sampleCount.size() != reference.size()) {
        throw Error("reference", "it holds no scatter to make covariances from", "build it from nominal maps");
    }
    std::vector<Eigen::Matrix3d> covariance;
    if (reference.size() > 0) covariance = smoothed(reference, settings, progress);
    std::vector<std::uint8_t> untrained(reference.size(), 0);
    const Eigen::Matrix3d added = settings.regularisation_m2 * Eigen::Matrix3d::Identity();
    for (std::size_t i = 0; i < reference.size(); ++i) {
        covariance[i] += added;
        if (isInvertible(covariance[i])) continue;
        covariance[i] = unknownCovariance();
        untrained[i] = 1;
    }
    reference.covariance = std::move(covariance);
    reference.untrained = std::move(untrained);
}

std::string provenanceOf(const CovarianceFitSettings& settings) {
    const SmoothingSettings& smoothing = settings.smoothing;
    std::ostringstream text;
    if (smoothing.neighbourhood == SmoothingNeighbourhood::Ball) {
        text << "covariance_radius_m " << smoothing.radius_m;
    } else {
        text << "covariance_neighbours " << smoothing.neighbours;
    }
    if (smoothing.weights == SmoothingWeights::Gaussian) text << " covariance_sigma_m " << smoothing.sigma_m;
    if (settings.smoothingVoxelSize_m) text << " covariance_voxel_size_m " << *settings.smoothingVoxelSize_m;
    if (settings.regularisation_m2 > 0.0) text << " covariance_regularisation_m2 " << settings.regularisation_m2;
    return text.str();
}

}  // namespace fodscope
