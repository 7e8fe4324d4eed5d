// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/planning/Waypoints.h"

namespace fodscope {

/// One pose of an inspection route.
struct RoutePose {
    /// "R-01"; given by numbered(), and never to two poses of a session.
    std::string id;
    Pose2 pose_map;
    bool takesPhoto = false;

    bool operator==(const RoutePose&) const = default;
};

/// The poses that the robot drives to, in their order, while it maps: the paper's first phase. The map comes after it.
struct InspectionRoute {
    std::vector<RoutePose> poses;
    /// The highest number that an id of the session has had.
    int highestNumber = 0;

    bool operator==(const InspectionRoute&) const = default;
};

/// @return whether an id is that of a route's pose, not of a plan's waypoint
bool isRoutePose(const std::string& waypointId);

/// Gives ids to the poses that have none.
InspectionRoute numbered(InspectionRoute route);

/// @return the route as a plan that a VisitRunner drives
VisitPlan planOf(const InspectionRoute& route);

/// Reads the YAML of routeYaml(). Poses come without ids.
/// @throws Error naming file and line for what is no YAML, another schema or frame, an unknown or missing key, a number
///         that is none or out of range, and for a route without poses
InspectionRoute readRoute(const std::filesystem::path& file);
InspectionRoute parseRoute(const std::string& yaml, const std::string& subject);

/// @return `schema`, `frame` and the poses in their order, metres and degrees
std::string routeYaml(const InspectionRoute& route);

}  // namespace fodscope
