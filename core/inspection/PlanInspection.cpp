// SPDX-License-Identifier: MIT
#include "core/common/Error.h"
#include "core/inspection/Inspection.h"
#include "core/planning/CostMap.h"
#include "core/planning/OccupancyGrid.h"

namespace fodscope {
namespace {

/// Every voxel above the threshold, clustered or not: none of them may hide a candidate from the camera.
std::vector<Eigen::Vector3d> discrepantPoints_map(const DetectionRecord& detection) {
    const CandidateSettings& settings = detection.parameters.candidates;
    const std::vector<double>& discrepancy = detection.field->smoothed(settings.metric);
    const Transform T_map_from_reference = detection.registration.T_reference_from_map.inverse();
    std::vector<Eigen::Vector3d> points_map;
    for (std::size_t i = 0; i < detection.field->size(); ++i) {
        if (discrepancy[i] > settings.threshold)
            points_map.push_back(T_map_from_reference * detection.field->points[i]);
    }
    return points_map;
}

}  // namespace

std::vector<PlanTarget> planTargets(const CandidateSet& candidates) {
    std::vector<PlanTarget> targets;
    for (const Candidate& candidate : candidates.candidates) {
        targets.push_back({candidate.id, candidate.centroid_map, candidate.size_m});
    }
    return targets;
}

VisitPlan planInspection(const InspectionState& state, const OccupancyGrid& grid_map, const Pose2& robot_map,
                         Progress& progress) {
    const bool hasCandidates = state.detection && state.detection->field && state.detection->candidates &&
                               !state.detection->candidates->candidates.empty();
    if (!hasCandidates) {
        throw Error("plan", "there are no candidates to visit", "lower the threshold or issue the report as it is");
    }
    const DetectionRecord& detection = *state.detection;
    const Parameters& parameters = state.parameters;
    progress.report("making the cost map", 0.0);
    CostMap collision = inflate(grid_map, parameters.costMap);
    floodFill(collision, robot_map);
    progress.report("making the cost map", 0.5);
    const CostMap sight = inflate(withoutCandidates(grid_map, discrepantPoints_map(detection)), parameters.costMap);
    const std::vector<PlanTarget> targets = planTargets(*detection.candidates);
    return planVisits(targets, collision, sight, robot_map, parameters.waypoints, progress);
}

}  // namespace fodscope
