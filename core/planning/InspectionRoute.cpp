// SPDX-License-Identifier: MIT
#include "core/planning/InspectionRoute.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <set>

#include "core/common/Error.h"
#include "core/common/Files.h"

namespace fodscope {
namespace {

constexpr const char* kSchema = "fodscope.route/1";
constexpr const char* kFrame = "map";
constexpr const char* kPrefix = "R-";
constexpr double kFarthest_m = 10000.0;
constexpr double kGreatestAngle_deg = 3600.0;
constexpr std::size_t kMostPoses = 10000;

/// Reads a route and names the line of what is wrong with it.
class RouteReader {
  public:
    explicit RouteReader(std::string subject) : subject_(std::move(subject)) {}

    InspectionRoute read(const YAML::Node& root) const {
        if (!root.IsMap()) fail(root, "holds no route");
        requireKeys(root, {"schema", "frame", "poses"});
        requireWord(root, "schema", kSchema);
        requireWord(root, "frame", kFrame);
        const YAML::Node poses = valueOf(root, "poses");
        if (!poses.IsSequence() || poses.size() == 0) fail(poses, "'poses' lists no pose");
        if (poses.size() > kMostPoses) fail(poses, "the route has more than 10000 poses");
        InspectionRoute route;
        for (const YAML::Node& pose : poses)
            route.poses.push_back(poseFrom(pose));
        return route;
    }

    [[noreturn]] void fail(int line, const std::string& problem) const {
        throw Error(subject_, "line " + std::to_string(line) + ": " + problem,
                    "write poses as {x: 1.2, y: 0.5, yaw_deg: 90, photo: false}, or save a route from the window");
    }

  private:
    [[noreturn]] void fail(const YAML::Node& where, const std::string& problem) const {
        // An empty document has no place.
        fail(std::max(1, where.Mark().line + 1), problem);
    }

    RoutePose poseFrom(const YAML::Node& node) const {
        if (!node.IsMap()) fail(node, "this is no pose");
        requireKeys(node, {"x", "y", "yaw_deg", "photo"});
        RoutePose pose;
        pose.pose_map.x_m = numberOf(node, "x", kFarthest_m);
        pose.pose_map.y_m = numberOf(node, "y", kFarthest_m);
        pose.pose_map.yaw_rad = wrapAngle(radiansFromDegrees(numberOf(node, "yaw_deg", kGreatestAngle_deg)));
        if (!node["photo"]) return pose;
        const std::string word = scalarOf(node, "photo");
        if (word != "true" && word != "false") fail(node["photo"], "'photo' is '" + word + "', not true or false");
        pose.takesPhoto = word == "true";
        return pose;
    }

    void requireKeys(const YAML::Node& node, const std::set<std::string>& known) const {
        std::set<std::string> seen;
        for (const auto& entry : node) {
            const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
            if (!known.contains(key)) fail(entry.first, "the key '" + key + "' is unknown");
            if (!seen.insert(key).second) fail(entry.first, "the key '" + key + "' is there twice");
        }
    }

    void requireWord(const YAML::Node& root, const char* key, const std::string& word) const {
        const std::string found = scalarOf(root, key);
        if (found != word) fail(root[key], "'" + std::string(key) + "' is '" + found + "', not '" + word + "'");
    }

    YAML::Node valueOf(const YAML::Node& node, const char* key) const {
        const YAML::Node value = node[key];
        if (!value.IsDefined()) fail(node, "the key '" + std::string(key) + "' is missing");
        return value;
    }

    std::string scalarOf(const YAML::Node& node, const char* key) const {
        const YAML::Node value = valueOf(node, key);
        if (!value.IsScalar()) fail(value, "'" + std::string(key) + "' is no single value");
        return value.Scalar();
    }

    double numberOf(const YAML::Node& node, const char* key, double greatest) const {
        const std::string text = scalarOf(node, key);
        double number = 0.0;
        const char* first = text.data() + (text.starts_with('+') ? 1 : 0);
        const auto end = std::from_chars(first, text.data() + text.size(), number);
        if (end.ec != std::errc() || end.ptr != text.data() + text.size() || !std::isfinite(number))
            fail(node[key], "'" + std::string(key) + "' is '" + text + "', which is no number");
        if (std::abs(number) > greatest) fail(node[key], "'" + std::string(key) + "' is out of range: " + text);
        return number;
    }

    std::string subject_;
};

/// @return the number with at most this many decimals, without trailing zeros
std::string shortNumber(double value, int decimals) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    std::string number = text;
    number.erase(number.find_last_not_of('0') + 1);
    if (number.ends_with('.')) number.pop_back();
    return number == "-0" ? "0" : number;
}

}  // namespace

bool isRoutePose(const std::string& waypointId) {
    return waypointId.starts_with(kPrefix);
}

InspectionRoute numbered(InspectionRoute route) {
    for (RoutePose& pose : route.poses) {
        if (!pose.id.empty()) continue;
        char text[32];
        std::snprintf(text, sizeof text, "%s%02d", kPrefix, ++route.highestNumber);
        pose.id = text;
    }
    return route;
}

VisitPlan planOf(const InspectionRoute& route) {
    VisitPlan plan;
    for (const RoutePose& pose : route.poses) {
        Waypoint waypoint;
        waypoint.id = pose.id;
        waypoint.pose_map = pose.pose_map;
        waypoint.status = WaypointStatus::Ok;
        waypoint.takesPhoto = pose.takesPhoto;
        plan.waypoints.push_back(waypoint);
    }
    return plan;
}

InspectionRoute parseRoute(const std::string& yaml, const std::string& subject) {
    const RouteReader reader(subject);
    try {
        return reader.read(YAML::Load(yaml));
    } catch (const YAML::Exception& exception) {
        reader.fail(exception.mark.line + 1, "this is no YAML (" + exception.msg + ")");
    }
}

InspectionRoute readRoute(const std::filesystem::path& file) {
    return parseRoute(readTextFile(file), file.string());
}

std::string routeYaml(const InspectionRoute& route) {
    std::string text =
        "# Inspection route of Fodscope: where the robot drives while it maps, in this order. Metres and degrees.\n";
    text += std::string("schema: ") + kSchema + "\nframe: " + kFrame + "\nposes:\n";
    for (const RoutePose& pose : route.poses) {
        text += "  - {x: " + shortNumber(pose.pose_map.x_m, 4) + ", y: " + shortNumber(pose.pose_map.y_m, 4) +
                ", yaw_deg: " + shortNumber(degreesFromRadians(pose.pose_map.yaw_rad), 3) +
                ", photo: " + (pose.takesPhoto ? "true" : "false") + "}\n";
    }
    return text;
}

}  // namespace fodscope
