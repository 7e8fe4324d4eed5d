// SPDX-License-Identifier: MIT
#include "core/detection/Discrepancy.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <string>

#include "core/cloud/VoxelGrid.h"
#include "core/common/Error.h"

namespace fodscope {
namespace {

void check(const DiscrepancySettings& settings) {
    if (!(settings.voxelSize_m > 0.0) || !std::isfinite(settings.voxelSize_m)) {
        throw Error("discrepancy voxel", "must be greater than 0", "give a length in metres such as 0.02");
    }
    if (settings.smoothingNeighbours < 1) {
        throw Error("smoothing neighbours", "must be at least 1, not " + std::to_string(settings.smoothingNeighbours),
                    "give a whole number such as 50, or 1 for no smoothing");
    }
    if (settings.cropHeight_m && !std::isfinite(*settings.cropHeight_m)) {
        throw Error("crop height", "is not a finite number", "give a height in metres such as 0.6");
    }
}

/// Strictly inside the reference's bounds, as the published code does; the crop height lowers the upper one.
std::vector<Eigen::Vector3d> cropped(std::span<const Eigen::Vector3d> map, const Transform& T_reference_from_map,
                                     const ReferenceMap& reference, const DiscrepancySettings& settings) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Eigen::Vector3d low = Eigen::Vector3d::Constant(-infinity);
    Eigen::Vector3d high = Eigen::Vector3d::Constant(infinity);
    if (settings.cropToReference) {
        low = minimumCorner(reference.points);
        high = maximumCorner(reference.points);
    }
    if (settings.cropHeight_m) high.z() = std::min(high.z(), *settings.cropHeight_m);
    std::vector<Eigen::Vector3d> inside;
    inside.reserve(map.size());
    for (const Eigen::Vector3d& point : map) {
        const Eigen::Vector3d moved = T_reference_from_map * point;
        if ((moved.array() > low.array()).all() && (moved.array() < high.array()).all()) inside.push_back(moved);
    }
    if (inside.empty()) {
        throw Error("map", "no point of it lies within the reference map (below the crop height)",
                    "check that map and reference show the same space, the transform and the crop height");
    }
    return inside;
}

/// Paper eq. "M-dist_local".
void measureMahalanobis(const ReferenceMap& reference, DiscrepancyField& field) {
    field.mahalanobis.assign(field.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < field.size(); ++i) {
        const std::uint32_t nearest = field.nearest[i];
        if (!reference.untrained.empty() && reference.untrained[nearest] != 0) continue;
        const Eigen::LLT<Eigen::Matrix3d> factor(reference.covariance[nearest]);
        if (factor.info() != Eigen::Success) continue;
        const Eigen::Vector3d deviation = field.points[i] - reference.points[nearest];
        field.mahalanobis[i] = factor.matrixL().solve(deviation).norm();
    }
}

/// Σ n_j d_j / Σ n_j over those neighbours whose discrepancy is known.
double weightedMean(std::span<const Neighbour> neighbours, const std::vector<double>& values,
                    const std::vector<std::uint32_t>& weights) {
    double sum = 0.0;
    double weight = 0.0;
    for (const Neighbour& neighbour : neighbours) {
        const double value = values[neighbour.index];
        if (std::isnan(value)) continue;
        sum += weights[neighbour.index] * value;
        weight += weights[neighbour.index];
    }
    return weight > 0.0 ? sum / weight : std::numeric_limits<double>::quiet_NaN();
}

void smooth(DiscrepancyField& field, int neighbourCount, Progress& progress) {
    if (neighbourCount == 1) {
        field.smoothedEuclidean_m = field.euclidean_m;
        field.smoothedMahalanobis = field.mahalanobis;
        return;
    }
    field.smoothedEuclidean_m.resize(field.size());
    field.smoothedMahalanobis.resize(field.mahalanobis.size());
    const NeighbourIndex voxels(field.points);
    voxels.forEachKNearest(
        field.points, static_cast<std::size_t>(neighbourCount),
        [&](std::size_t i, std::span<const Neighbour> neighbours) {
            field.smoothedEuclidean_m[i] = weightedMean(neighbours, field.euclidean_m, field.weights);
            if (field.hasMahalanobis())
                field.smoothedMahalanobis[i] = weightedMean(neighbours, field.mahalanobis, field.weights);
        },
        progress, "smoothing the discrepancy");
}

}  // namespace

const std::vector<double>& DiscrepancyField::smoothed(Metric metric) const {
    if (metric == Metric::Euclidean) return smoothedEuclidean_m;
    if (!hasMahalanobis()) {
        throw Error("Mahalanobis discrepancy", "the reference map has no covariances",
                    "build it from nominal maps, or choose the Euclidean discrepancy");
    }
    return smoothedMahalanobis;
}

DiscrepancyField measureDiscrepancy(std::span<const Eigen::Vector3d> map, const Transform& T_reference_from_map,
                                    const ReferenceMap& reference, const DiscrepancySettings& settings,
                                    Progress& progress) {
    check(settings);
    if (reference.size() == 0) throw Error("reference map", "it has no points", "build it anew");
    progress.report("voxels of the map", 0.0);
    const std::vector<Eigen::Vector3d> inside = cropped(map, T_reference_from_map, reference, settings);
    VoxelCloud voxels = voxelGrid(inside, minimumCorner(inside), {settings.voxelSize_m});

    DiscrepancyField field;
    field.points = std::move(voxels.points);
    field.weights = std::move(voxels.weights);
    field.nearest.reserve(field.size());
    field.euclidean_m.reserve(field.size());
    const NeighbourIndex index(reference.points);
    for (const Neighbour& nearest : index.nearestOfEach(field.points, progress, "nearest reference points")) {
        field.nearest.push_back(nearest.index);
        field.euclidean_m.push_back(std::sqrt(nearest.squaredDistance_m2));
    }
    if (reference.hasCovariance()) measureMahalanobis(reference, field);
    smooth(field, settings.smoothingNeighbours, progress);
    return field;
}

}  // namespace fodscope
