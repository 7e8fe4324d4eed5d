// SPDX-License-Identifier: MIT
#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/planning/Waypoints.h"

namespace fodscope {

std::string waypointsJson(const VisitPlan& plan) {
    using Json = nlohmann::ordered_json;
    Json waypoints = Json::array();
    for (const Waypoint& waypoint : plan.waypoints) {
        Json entry;
        entry["id"] = waypoint.id;
        entry["candidates"] = waypoint.candidateIds;
        entry["pose_map"] = nullptr;
        entry["cost"] = nullptr;
        if (waypoint.pose_map) {
            entry["pose_map"] = {{"x", waypoint.pose_map->x_m},
                                 {"y", waypoint.pose_map->y_m},
                                 {"yaw_deg", degreesFromRadians(waypoint.pose_map->yaw_rad)}};
            entry["cost"] = waypoint.cost;
        }
        entry["status"] = toString(waypoint.status);
        waypoints.push_back(std::move(entry));
    }
    Json candidates = Json::array();
    for (const CandidateView& view : plan.views) {
        Json ids = Json::array();
        for (const Waypoint& waypoint : plan.waypoints) {
            if (waypoint.pose_map &&
                std::ranges::find(waypoint.candidateIds, view.candidateId) != waypoint.candidateIds.end())
                ids.push_back(waypoint.id);
        }
        candidates.push_back(
            {{"id", view.candidateId}, {"waypoints", ids}, {"shown", view.share}, {"rest", toString(view.rest)}});
    }
    const auto orNull = [](const std::optional<double>& length_m) { return length_m ? Json(*length_m) : Json(); };
    Json file;
    file["schema"] = "fodscope.waypoints/1";
    file["waypoints"] = std::move(waypoints);
    file["length_m"] = plan.length_m;
    file["nearest_next_m"] = orNull(plan.nearestNextLength_m);
    file["shortest_tour_m"] = orNull(plan.shortestTourLength_m);
    file["candidates"] = std::move(candidates);
    return file.dump(2) + "\n";
}

}  // namespace fodscope
