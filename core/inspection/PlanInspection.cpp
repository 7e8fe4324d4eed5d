// SPDX-License-Identifier: MIT
#include <cmath>

#include "core/common/Error.h"
#include "core/inspection/Inspection.h"
#include "core/planning/CostMap.h"
#include "core/planning/OccupancyGrid.h"

namespace fodscope {
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

std::vector<PlanTarget> planTargets(const DetectionRecord& detection) {
    std::vector<PlanTarget> targets;
    if (!detection.candidates) return targets;
    const Transform T_map_from_reference = detection.registration.T_reference_from_map.inverse();
    for (const Candidate& candidate : detection.candidates->candidates) {
        PlanTarget target{candidate.id, candidate.centroid_map, candidate.size_m, 0.0, {}, 0.0};
        const Eigen::Vector3d direction =
            T_map_from_reference.linear() *
            Eigen::Vector3d(std::cos(candidate.lengthDirection_rad), std::sin(candidate.lengthDirection_rad), 0.0);
        target.lengthDirection_rad = std::atan2(direction.y(), direction.x());
        target.voxelSize_m = detection.parameters.discrepancy.voxelSize_m;
        if (detection.field) {
            for (const std::uint32_t voxel : candidate.voxels) {
                const Eigen::Vector3d& point_reference = detection.field->points[voxel];
                const Eigen::Vector3d point_map = T_map_from_reference * point_reference;
                target.voxels.emplace_back(point_map.x(), point_map.y(), point_reference.z() - detection.floorHeight_m);
            }
        }
        targets.push_back(std::move(target));
    }
    return targets;
}

namespace {

void requireCandidates(const InspectionState& state) {
    const bool hasCandidates = state.detection && state.detection->field && state.detection->candidates &&
                               !state.detection->candidates->candidates.empty();
    if (!hasCandidates)
        throw Error("plan", "there are no candidates to visit", "lower the threshold or issue the report as it is");
}

/// Where the robot can drive, and what it can see over.
struct PlanMaps {
    CostMap collision;
    CostMap sight;
};

PlanMaps planMaps(const InspectionState& state, const OccupancyGrid& grid_map, const Pose2& robot_map,
                  Progress& progress) {
    const CostMapSettings& settings = state.parameters.costMap;
    progress.report("making the cost map", 0.0);
    PlanMaps maps{inflate(grid_map, settings), {}};
    floodFill(maps.collision, robot_map);
    progress.report("making the cost map", 0.5);
    maps.sight = inflate(withoutCandidates(grid_map, discrepantPoints_map(*state.detection)), settings);
    return maps;
}

}  // namespace

VisitPlan planInspection(const InspectionState& state, const OccupancyGrid& grid_map, const Pose2& robot_map,
                         Progress& progress) {
    requireCandidates(state);
    const PlanMaps maps = planMaps(state, grid_map, robot_map, progress);
    const Parameters& parameters = state.parameters;
    return planVisits(planTargets(*state.detection), maps.collision, maps.sight, robot_map, parameters.waypoints,
                      parameters.camera, progress);
}

VisitPlan replanInspection(const InspectionState& state, std::span<const PlannedStop> stops, Progress& progress) {
    requireCandidates(state);
    if (!state.plan || !state.grid_map) throw Error("plan", "there is none yet", "plan the visits first");
    const PlanMaps maps = planMaps(state, *state.grid_map, state.plan->start_map, progress);
    const Parameters& parameters = state.parameters;
    return planOfStops(stops, planTargets(*state.detection), maps.collision, maps.sight, *state.plan,
                       parameters.waypoints, parameters.camera, progress);
}

}  // namespace fodscope
