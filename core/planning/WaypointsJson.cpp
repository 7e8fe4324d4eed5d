// SPDX-License-Identifier: MIT
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
    Json file;
    file["schema"] = "fodscope.waypoints/1";
    file["waypoints"] = std::move(waypoints);
    file["length_m"] = plan.length_m;
    return file.dump(2) + "\n";
}

}  // namespace fodscope
