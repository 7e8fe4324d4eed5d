// SPDX-License-Identifier: MIT
#include "core/detection/Discrepancy.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/cloud/Bounds.h"
#include "core/cloud/RandomSample.h"
#include "core/cloud/VoxelGrid.h"
#include "core/common/Error.h"

namespace fodscope {
namespace {

constexpr const char* kDefaultsRemedy = "the defaults are 0.02 m voxels, a ratio of 0.1, 50 neighbours and 1 pass";

void check(const DiscrepancySettings& settings) {
    std::vector<std::string> problems;
    if (!(settings.voxelSize_m > 0.0) || !std::isfinite(settings.voxelSize_m)) {
        problems.push_back("the voxel size must be greater than 0");
    }
    if (!(settings.randomRatio > 0.0 && settings.randomRatio <= 1.0)) {
        problems.push_back("the random ratio must be greater than 0 and at most 1");
    }
    if (settings.cropHeight_m && !std::isfinite(*settings.cropHeight_m)) {
        problems.push_back("the crop height must be a finite number");
    }
    for (const std::string& problem : smoothingProblems(settings.smoothing))
        problems.push_back("smoothing: " + problem);
    if (settings.smoothingPasses < 0) problems.push_back("the smoothing passes must not be negative");
    if (problems.empty()) return;
    std::string text = problems.front();
    for (std::size_t i = 1; i < problems.size(); ++i)
        text += ", " + problems[i];
    throw Error("discrepancy settings", text, kDefaultsRemedy);
}

/// Strictly inside the reference's bounds, as the published code does; the crop height lowers the upper one.
MovedPoints cropped(std::span<const Eigen::Vector3d> map, const Transform& T_reference_from_map,
                    const ReferenceMap& reference, const DiscrepancySettings& settings) {
    MovedPoints points{map, T_reference_from_map};
    if (settings.cropToReference) {
        const Bounds bounds = boundsOf(reference.points);
        points.low = bounds.low;
        points.high = bounds.high;
    }
    if (settings.cropHeight_m) points.high.z() = std::min(points.high.z(), *settings.cropHeight_m);
    return points;
}

void check(const ReferenceMap& reference) {
    if (reference.size() == 0) throw Error("reference map", "it has no points", "build it anew");
    const auto fits = [&](std::size_t size) { return size == 0 || size == reference.size(); };
    if (!fits(reference.covariance.size()) || !fits(reference.untrained.size())) {
        throw Error("reference map", "it has not one covariance a point", "build it anew");
    }
}

/// Paper eq. "M-dist_local".
void measureMahalanobis(const ReferenceMap& reference, DiscrepancyField& field) {
    field.mahalanobis.assign(field.size(), std::numeric_limits<double>::quiet_NaN());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, field.size(), 1024), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const std::uint32_t nearest = field.nearest[i];
            if (!reference.untrained.empty() && reference.untrained[nearest] != 0) continue;
            if (!reference.covariance[nearest].allFinite()) continue;
            const Eigen::LLT<Eigen::Matrix3d> factor(reference.covariance[nearest]);
            if (factor.info() != Eigen::Success) continue;
            const Eigen::Vector3d deviation = field.points[i] - reference.points[nearest];
            field.mahalanobis[i] = factor.matrixL().solve(deviation).norm();
        }
    });
}

VoxelCloud sampled(const MovedPoints& map, const DiscrepancySettings& settings) {
    std::vector<Eigen::Vector3d> inside;
    for (std::size_t i = 0; i < map.size(); ++i) {
        Eigen::Vector3d point;
        if (map.get(i, point)) inside.push_back(point);
    }
    VoxelCloud kept;
    const auto seed = static_cast<std::uint64_t>(settings.randomSeed);
    for (const std::uint32_t index : randomSample(inside.size(), settings.randomRatio, seed))
        kept.points.push_back(inside[index]);
    kept.weights.assign(kept.size(), 1);
    return kept;
}

/// The map in voxels, or a share of its points in their order.
VoxelCloud thinned(const MovedPoints& map, const DiscrepancySettings& settings) {
    VoxelCloud voxels =
        settings.downSampling == DownSampling::Voxel ? voxelGrid(map, {settings.voxelSize_m}) : sampled(map, settings);
    if (voxels.size() == 0) {
        throw Error("map", "no point of it lies within the reference map (below the crop height)",
                    "check that map and reference show the same space, the transform and the crop height");
    }
    return voxels;
}

/// Σ w_j n_j d_j / Σ w_j n_j over those neighbours whose discrepancy is known.
double weightedMean(std::span<const Neighbour> neighbours, const std::vector<double>& values,
                    const std::vector<std::uint32_t>& counts, const SmoothingSettings& settings) {
    double sum = 0.0;
    double weights = 0.0;
    for (const Neighbour& neighbour : neighbours) {
        const double value = values[neighbour.index];
        if (std::isnan(value)) continue;
        const double weight = counts[neighbour.index] * smoothingWeight(settings, neighbour.squaredDistance_m2);
        sum += weight * value;
        weights += weight;
    }
    return weights > 0.0 ? sum / weights : std::numeric_limits<double>::quiet_NaN();
}

bool changesNothing(const SmoothingSettings& settings) {
    return settings.neighbourhood == SmoothingNeighbourhood::NearestNeighbours && settings.neighbours == 1;
}

void smooth(DiscrepancyField& field, const DiscrepancySettings& settings, Progress& progress) {
    field.smoothedEuclidean_m = field.euclidean_m;
    field.smoothedMahalanobis = field.mahalanobis;
    if (settings.smoothingPasses == 0 || changesNothing(settings.smoothing)) return;
    const NeighbourIndex voxels(field.points, progress);
    for (int pass = 0; pass < settings.smoothingPasses; ++pass) {
        const std::vector<double> euclidean_m = field.smoothedEuclidean_m;
        const std::vector<double> mahalanobis = field.smoothedMahalanobis;
        forEachNeighbourhood(
            voxels, field.points, settings.smoothing, "discrepancy smoothing",
            [&](std::size_t i, std::span<const Neighbour> near) {
                field.smoothedEuclidean_m[i] = weightedMean(near, euclidean_m, field.weights, settings.smoothing);
                if (field.hasMahalanobis())
                    field.smoothedMahalanobis[i] = weightedMean(near, mahalanobis, field.weights, settings.smoothing);
            },
            progress, "smoothing the discrepancy");
    }
}

}  // namespace

bool DiscrepancyField::has(Metric metric) const {
    if (metric == Metric::Mahalanobis) return hasMahalanobis();
    return metric == Metric::Euclidean || !chiSquare.empty();
}

const std::vector<double>& DiscrepancyField::smoothed(Metric metric) const {
    if (metric == Metric::Euclidean) return smoothedEuclidean_m;
    if (metric == Metric::ChiSquare) {
        if (!has(metric)) throw Error("chi-square discrepancy", "it was not computed", "detect anew with that metric");
        return chiSquare;
    }
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
    check(reference);
    progress.report("voxels of the map", 0.0);
    VoxelCloud voxels = thinned(cropped(map, T_reference_from_map, reference, settings), settings);

    DiscrepancyField field;
    field.points = std::move(voxels.points);
    field.weights = std::move(voxels.weights);
    field.nearest.reserve(field.size());
    field.euclidean_m.reserve(field.size());
    const NeighbourIndex index(reference.points, progress);
    for (const Neighbour& nearest : index.nearestOfEach(field.points, progress, "nearest reference points")) {
        field.nearest.push_back(nearest.index);
        field.euclidean_m.push_back(std::sqrt(nearest.squaredDistance_m2));
    }
    if (reference.hasCovariance()) measureMahalanobis(reference, field);
    smooth(field, settings, progress);
    return field;
}

DiscrepancyField withChiSquare(const DiscrepancyField& field, const LocalStatisticalTestSettings& settings,
                               Progress& progress) {
    DiscrepancyField tested = field;
    tested.chiSquare = localStatisticalTest(field.points, field.euclidean_m, settings, progress);
    return tested;
}

}  // namespace fodscope
