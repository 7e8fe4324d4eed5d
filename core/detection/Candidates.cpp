// SPDX-License-Identifier: MIT
#include "core/detection/Candidates.h"

#include <utility>

#include "core/detection/CandidateMeasures.h"

namespace fodscope {
namespace {

std::vector<std::vector<std::uint32_t>> clustersOf(const DiscrepancyField& field,
                                                   const std::vector<std::uint32_t>& voxels,
                                                   const CandidateSettings& settings, Progress& progress) {
    std::vector<Eigen::Vector3d> points;
    points.reserve(voxels.size());
    for (const std::uint32_t voxel : voxels)
        points.push_back(field.points[voxel]);
    const std::vector<std::uint32_t> labels =
        linkageClusters(points, settings.linkage, settings.clusterCutoff_m, progress);
    std::vector<std::vector<std::uint32_t>> clusters;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        // Labels are numbered by first point, so a new one is always the next.
        if (labels[i] == clusters.size()) clusters.emplace_back();
        clusters[labels[i]].push_back(voxels[i]);
    }
    return clusters;
}

}  // namespace

CandidateSettings paperPhysicalCandidateSettings(Metric metric) {
    CandidateSettings settings;
    settings.metric = metric;
    if (metric != Metric::Mahalanobis) {
        settings.threshold = metric == Metric::Euclidean ? 0.030 : testThreshold({});
        settings.clusterCutoff_m = 0.279;
        settings.minimumPoints = 4;
    }
    return settings;
}

CandidateSet findCandidates(const DiscrepancyField& field, const CandidateSettings& settings, double voxelSize_m,
                            double floorHeight_m, const Transform& T_reference_from_map, Progress& progress) {
    checkCandidateSettings(settings, voxelSize_m);
    const std::vector<double>& discrepancy = field.smoothed(settings.metric);
    const std::vector<std::uint32_t> above = voxelsAbove(discrepancy, settings.threshold);
    const CandidateFrame frame{voxelSize_m, floorHeight_m, T_reference_from_map.inverse()};
    CandidateSet set;
    set.candidateOfVoxel.assign(field.size(), -1);
    set.pointsAboveThreshold = above.size();
    for (std::vector<std::uint32_t>& voxels : clustersOf(field, above, settings, progress)) {
        if (voxels.size() < static_cast<std::size_t>(settings.minimumPoints)) continue;
        set.candidates.push_back(measuredCandidate(field, discrepancy, std::move(voxels), settings.centroid, frame));
    }
    arrangeCandidates(set);
    return set;
}

}  // namespace fodscope
