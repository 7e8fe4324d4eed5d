// SPDX-License-Identifier: MIT
#include "ui/plan/PlanScene.h"

#include <algorithm>

#include "core/common/Error.h"

namespace fodscope {

namespace {

std::shared_ptr<const CostMap> makeCostMap(const InspectionState& state) {
    if (!state.grid_map || state.grid_map->cells.empty()) return nullptr;
    auto costMap = std::make_shared<CostMap>(inflate(*state.grid_map, state.parameters.costMap));
    if (state.plan) {
        try {
            floodFill(*costMap, state.plan->start_map);
        } catch (const Error&) {
            // The robot stood outside the grid: what it reaches is not known, and nothing is shown as unreachable.
            costMap->reachable.clear();
        }
    }
    return costMap;
}

std::vector<PlanCandidate> makeCandidates(const InspectionState& state) {
    std::vector<PlanCandidate> items;
    if (!state.detection || !state.detection->candidates) return items;
    for (const Candidate& candidate : state.detection->candidates->candidates) {
        PlanCandidate item;
        item.id = candidate.id;
        item.centroid_map = candidate.centroid_map.head<2>();
        item.radius_m = 0.5 * candidate.size_m.head<2>().norm();
        items.push_back(std::move(item));
    }
    for (const CandidateVerdict& verdict : verdictsOf(state)) {
        const auto item = std::find_if(items.begin(), items.end(),
                                       [&](const PlanCandidate& each) { return each.id == verdict.candidateId; });
        if (item != items.end()) item->verdict = verdict.verdict;
    }
    return items;
}

void addWaypoints(const VisitPlan& plan, PlanScene& scene) {
    scene.length_m = plan.length_m;
    scene.start_map = plan.start_map;
    for (const Waypoint& waypoint : plan.waypoints) {
        if (!waypoint.pose_map) {
            for (PlanCandidate& candidate : scene.candidates) {
                const auto& ids = waypoint.candidateIds;
                if (std::find(ids.begin(), ids.end(), candidate.id) != ids.end()) {
                    candidate.noWaypointReason = toString(waypoint.status);
                }
            }
            continue;
        }
        PlanWaypoint item;
        item.id = waypoint.id;
        item.number = static_cast<int>(scene.waypoints.size()) + 1;
        item.candidateIds = waypoint.candidateIds;
        item.pose_map = *waypoint.pose_map;
        item.drive_map = waypoint.drive.points_map;
        scene.waypoints.push_back(std::move(item));
    }
    for (PlanCandidate& candidate : scene.candidates) {
        const auto view = std::ranges::find(plan.views, candidate.id, &CandidateView::candidateId);
        if (view == plan.views.end()) continue;
        candidate.plannedShare = view->share;
        candidate.noWaypointReason = view->rest == WaypointStatus::Ok ? std::string() : toString(view->rest);
    }
}

}  // namespace

PlanScene planScene(const InspectionState& state) {
    PlanScene scene;
    scene.viewAngle_rad = state.parameters.camera.horizontalFieldOfView_rad;
    scene.costMap = makeCostMap(state);
    scene.candidates = makeCandidates(state);
    if (state.plan) addWaypoints(*state.plan, scene);
    updateVisits(scene, state.visits);
    if (!scene.costMap && state.detection && state.detection->field) {
        const Transform T_map_from_reference = state.detection->registration.T_reference_from_map.inverse();
        scene.pointsFromAbove_map.reserve(state.detection->field->size());
        for (const Eigen::Vector3d& point : state.detection->field->points) {
            scene.pointsFromAbove_map.push_back((T_map_from_reference * point).head<2>());
        }
    }
    return scene;
}

PlanScene routeScene(const InspectionState& state, const OccupancyGrid* grid_map) {
    PlanScene scene;
    scene.isRoute = true;
    if (grid_map != nullptr && !grid_map->cells.empty())
        scene.costMap = std::make_shared<CostMap>(inflate(*grid_map, state.parameters.costMap));
    for (const Waypoint& waypoint : planOf(state.route).waypoints) {
        PlanWaypoint item;
        item.id = waypoint.id;
        item.number = static_cast<int>(scene.waypoints.size()) + 1;
        item.pose_map = *waypoint.pose_map;
        item.takesPhoto = waypoint.takesPhoto;
        scene.waypoints.push_back(std::move(item));
    }
    updateVisits(scene, state.routeVisits);
    return scene;
}

void updateVisits(PlanScene& scene, const std::vector<Visit>& visits) {
    for (PlanWaypoint& waypoint : scene.waypoints) {
        const auto visit = std::find_if(visits.begin(), visits.end(),
                                        [&](const Visit& each) { return each.waypointId == waypoint.id; });
        waypoint.state = visit == visits.end() ? VisitState::Draft : visit->state;
        waypoint.reason = visit == visits.end() ? std::string() : reasonText(*visit);
    }
}

}  // namespace fodscope
