// SPDX-License-Identifier: MIT
#include "core/detection/CandidateMeasures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "core/common/Error.h"
#include "core/detection/LeastAreaRectangle.h"

namespace fodscope {
namespace {

Eigen::Vector3d centroidOf(const DiscrepancyField& field, const std::vector<std::uint32_t>& voxels,
                           const std::vector<double>& discrepancy, CentroidKind kind) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double weights = 0.0;
    for (const std::uint32_t voxel : voxels) {
        const double weight = kind == CentroidKind::DiscrepancyWeighted ? discrepancy[voxel] : 1.0;
        sum += weight * field.points[voxel];
        weights += weight;
    }
    return sum / weights;
}

void measureSize(const DiscrepancyField& field, double voxelSize_m, Candidate& candidate) {
    std::vector<Eigen::Vector2d> plan;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const std::uint32_t voxel : candidate.voxels) {
        const Eigen::Vector3d& point = field.points[voxel];
        plan.emplace_back(point.head<2>());
        low = std::min(low, point.z());
        high = std::max(high, point.z());
    }
    const OrientedRectangle rectangle = leastAreaRectangle(std::move(plan));
    candidate.size_m =
        Eigen::Vector3d(rectangle.length_m, rectangle.width_m, high - low) + Eigen::Vector3d::Constant(voxelSize_m);
    candidate.lengthDirection_rad = rectangle.direction_rad;
}

void measureDiscrepancyOf(const std::vector<double>& discrepancy, Candidate& candidate) {
    for (const std::uint32_t voxel : candidate.voxels) {
        candidate.discrepancyMax = std::max(candidate.discrepancyMax, discrepancy[voxel]);
        candidate.discrepancySum += discrepancy[voxel];
    }
    candidate.discrepancyMean = candidate.discrepancySum / static_cast<double>(candidate.voxels.size());
}

}  // namespace

void checkCandidateSettings(const CandidateSettings& settings, double voxelSize_m) {
    if (!(settings.threshold >= 0.0) || !std::isfinite(settings.threshold)) {
        throw Error("threshold", "must be a finite number of at least 0",
                    "give for example 2.75 (Mahalanobis), 0.03 m (Euclidean) or 4.21 (chi-square)");
    }
    if (!(settings.clusterCutoff_m >= 0.0) || !std::isfinite(settings.clusterCutoff_m)) {
        throw Error("cluster cutoff", "must be a finite length of at least 0 m", "give for example 0.345");
    }
    if (settings.minimumPoints < 0) {
        throw Error("least points", "must not be negative", "give 0 or more");
    }
    if (!(voxelSize_m > 0.0) || !std::isfinite(voxelSize_m)) {
        throw Error("discrepancy voxel", "must be greater than 0", "give a length in metres such as 0.02");
    }
}

std::vector<std::uint32_t> voxelsAbove(const std::vector<double>& discrepancy, double threshold) {
    std::vector<std::uint32_t> above;
    for (std::size_t i = 0; i < discrepancy.size(); ++i) {
        if (discrepancy[i] > threshold) above.push_back(static_cast<std::uint32_t>(i));
    }
    return above;
}

Candidate measuredCandidate(const DiscrepancyField& field, const std::vector<double>& discrepancy,
                            std::vector<std::uint32_t> voxels, CentroidKind centroid, const CandidateFrame& frame) {
    Candidate candidate;
    candidate.voxels = std::move(voxels);
    candidate.centroid_reference = centroidOf(field, candidate.voxels, discrepancy, centroid);
    candidate.centroid_map = frame.T_map_from_reference * candidate.centroid_reference;
    candidate.heightAboveFloor_m = candidate.centroid_reference.z() - frame.floorHeight_m;
    measureSize(field, frame.voxelSize_m, candidate);
    measureDiscrepancyOf(discrepancy, candidate);
    return candidate;
}

void arrangeCandidates(CandidateSet& set) {
    std::stable_sort(set.candidates.begin(), set.candidates.end(), [](const Candidate& a, const Candidate& b) {
        if (a.discrepancySum != b.discrepancySum) return a.discrepancySum > b.discrepancySum;
        return a.voxels.front() < b.voxels.front();
    });
    for (std::size_t i = 0; i < set.candidates.size(); ++i) {
        char id[32];
        std::snprintf(id, sizeof(id), "C-%03zu", i + 1);
        set.candidates[i].id = id;
        for (const std::uint32_t voxel : set.candidates[i].voxels)
            set.candidateOfVoxel[voxel] = static_cast<std::int32_t>(i);
    }
}

}  // namespace fodscope
