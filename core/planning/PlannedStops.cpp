// SPDX-License-Identifier: MIT
#include "core/planning/PlannedStops.h"

#include <algorithm>
#include <cmath>

#include "core/common/Error.h"
#include "core/planning/PlanChecks.h"
#include "core/planning/VisitOrder.h"
#include "core/planning/WaypointSearch.h"

namespace fodscope {
namespace {

/// A photo that shows less of a candidate was not taken for it.
constexpr double kGoodPart = 0.1;
/// Rounding of voxels at the picture's edge.
constexpr double kAllOfIt = 0.999;

Error notThere(std::size_t number, const std::string& why) {
    return Error(waypointId(number), why, "put it on reachable floor, clear of obstacles and candidates");
}

void requireStandable(const SearchFloor& floor, const PlannedStop& stop, std::size_t number) {
    switch (floor.standingAt({stop.pose_map.x_m, stop.pose_map.y_m})) {
        case Standing::OutsideGrid:
            throw notThere(number, "lies outside the grid");
        case Standing::OnUnknown:
            throw notThere(number, "lies on floor that nothing is known of");
        case Standing::TooNear:
            throw notThere(number, "is too close to an obstacle or a candidate");
        case Standing::BeyondReach:
            throw notThere(number, "lies where the robot does not get to");
        case Standing::Reachable:
            return;
    }
}

/// Which voxels of a target a photo from the pose shows: those in its picture, unless something stands before them.
std::vector<std::uint8_t> voxelsShownFrom(const Pose2& pose_map, const PhotoPart& whole, const SearchFloor& floor,
                                          const CameraFit& fit, const CameraSettings& camera) {
    std::vector<std::uint8_t> isShown(whole.voxels.size(), 0);
    const CameraIntrinsics k = intrinsicsOf(camera);
    const Transform T_camera_from_floor = cameraPose(pose_map, camera).inverse();
    PlanTarget shown;
    shown.voxelSize_m = whole.voxelSize_m;
    for (std::size_t i = 0; i < whole.voxels.size(); ++i) {
        const Eigen::Vector3d seen = T_camera_from_floor * whole.voxels[i];
        const bool isSharp = seen.z() > camera.nearLimit_m && seen.norm() <= fit.range_m();
        if (!isSharp || !isInImage(pixelOf(seen, k), k)) continue;
        isShown[i] = 1;
        shown.voxels.push_back(whole.voxels[i]);
        shown.centroid_map += whole.voxels[i];
    }
    if (shown.voxels.empty()) return isShown;
    shown.centroid_map /= static_cast<double>(shown.voxels.size());
    if (!floor.costOfSight({pose_map.x_m, pose_map.y_m}, wholeOf(shown, 0))) std::ranges::fill(isShown, 0);
    return isShown;
}

double shareOf(const std::vector<std::uint8_t>& isShown) {
    if (isShown.empty()) return 0.0;
    return static_cast<double>(std::ranges::count(isShown, 1)) / static_cast<double>(isShown.size());
}

bool holds(const std::vector<std::string>& ids, const std::string& id) {
    return std::ranges::find(ids, id) != ids.end();
}

bool isFinite(const PlanTarget& target) {
    return target.centroid_map.allFinite() && target.size_m.allFinite();
}

/// @return why a candidate that no stop shows has none
WaypointStatus reasonWithout(const std::string& candidateId, const VisitPlan& before) {
    const auto view = std::ranges::find(before.views, candidateId, &CandidateView::candidateId);
    const bool hadNone = view != before.views.end() && view->share == 0.0;
    return hadNone ? view->rest : WaypointStatus::LeftOut;
}

}  // namespace

std::vector<PlannedStop> stopsOf(const VisitPlan& plan) {
    std::vector<PlannedStop> stops;
    for (const Waypoint& waypoint : plan.waypoints)
        if (waypoint.pose_map) stops.push_back({*waypoint.pose_map, waypoint.candidateIds});
    return stops;
}

VisitPlan planOfStops(std::span<const PlannedStop> stops, std::span<const PlanTarget> targets, const CostMap& collision,
                      const CostMap& sight, const VisitPlan& before, const WaypointSettings& settings,
                      const CameraSettings& camera, Progress& progress) {
    requireInRange(settings);
    requireSameLattice(collision, sight);
    const SearchFloor floor(collision, sight, targets, settings);
    const CameraFit fit(camera, settings);
    VisitPlan plan;
    plan.start_map = before.start_map;
    std::vector<Eigen::Vector2d> places_map{{plan.start_map.x_m, plan.start_map.y_m}};
    for (std::size_t i = 0; i < stops.size(); ++i) {
        requireStandable(floor, stops[i], i + 1);
        places_map.emplace_back(stops[i].pose_map.x_m, stops[i].pose_map.y_m);
        plan.waypoints.push_back(
            {waypointId(i + 1), stops[i].candidateIds, stops[i].pose_map, 0.0, WaypointStatus::Ok, {}});
    }
    const VisitLegs legs(collision, places_map, progress);
    plan.nearestNextLength_m = lengthOf(nearestNextOrder(legs.lengths_m()), legs.lengths_m());
    plan.shortestTourLength_m = lengthOf(shortestOrder(legs.lengths_m()), legs.lengths_m());
    for (std::size_t i = 0; i < stops.size(); ++i) {
        plan.waypoints[i].drive = legs.drive(i, i + 1);
        if (!std::isfinite(plan.waypoints[i].drive.length_m))
            throw notThere(i + 1, "lies where the robot does not get to");
        plan.length_m += plan.waypoints[i].drive.length_m;
    }
    for (const PlanTarget& target : targets) {
        progress.throwIfCancelled();
        CandidateView view{target.candidateId, 0.0, reasonWithout(target.candidateId, before)};
        if (isFinite(target)) {
            const PhotoPart whole = wholeOf(target, 0);
            std::vector<std::uint8_t> isShown(whole.voxels.size(), 0);
            for (std::size_t i = 0; i < stops.size(); ++i) {
                const auto here = voxelsShownFrom(stops[i].pose_map, whole, floor, fit, camera);
                Waypoint& waypoint = plan.waypoints[i];
                if (stops[i].candidateIds.empty() && shareOf(here) >= kGoodPart)
                    waypoint.candidateIds.push_back(target.candidateId);
                if (!holds(waypoint.candidateIds, target.candidateId)) continue;
                waypoint.cost += floor.costOfSight({stops[i].pose_map.x_m, stops[i].pose_map.y_m}, whole).value_or(0.0);
                for (std::size_t voxel = 0; voxel < here.size(); ++voxel)
                    isShown[voxel] |= here[voxel];
            }
            view.share = shareOf(isShown);
            if (view.share > 0.0) {
                const auto known = std::ranges::find(before.views, view.candidateId, &CandidateView::candidateId);
                const bool isAsBefore = known != before.views.end() && view.share >= known->share - 1e-9;
                view.rest = isAsBefore ? known->rest : WaypointStatus::LeftOut;
            }
            if (view.share >= kAllOfIt) view = {view.candidateId, 1.0, WaypointStatus::Ok};
        }
        plan.views.push_back(view);
        if (view.share == 0.0) plan.waypoints.push_back({"", {view.candidateId}, std::nullopt, 0.0, view.rest, {}});
    }
    for (std::size_t i = stops.size(); i < plan.waypoints.size(); ++i)
        plan.waypoints[i].id = waypointId(i + 1);
    return plan;
}

}  // namespace fodscope
