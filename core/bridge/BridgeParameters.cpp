// SPDX-License-Identifier: MIT
#include "core/bridge/BridgeParameters.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <sstream>

#include "core/common/Error.h"

namespace fodscope::bridge {
namespace {

bool isName(const std::string& text) {
    const auto allowed = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '/'; };
    return !text.empty() && (std::isalpha(static_cast<unsigned char>(text[0])) || text[0] == '/') &&
           std::all_of(text.begin(), text.end(), allowed) && text.back() != '/' && text.find("//") == std::string::npos;
}

bool isPositiveNumber(const std::string& text) {
    double value = 0.0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    return problem == std::errc() && end == text.data() + text.size() && std::isfinite(value) && value > 0.0;
}

bool isOneOf(const std::string& text, const char* words) {
    std::istringstream stream(words);
    std::string word;
    while (stream >> word)
        if (word == text) return true;
    return false;
}

void requireValid(const ParameterInfo& info, const std::string& value) {
    switch (info.kind) {
        case ParameterKind::Topic:
        case ParameterKind::Frame:
        case ParameterKind::Service:
            if (!isName(value))
                throw Error(info.label, "'" + value + "' is no name that ROS allows",
                            std::string("give one like ") + info.usual);
            return;
        case ParameterKind::Number:
            if (!isPositiveNumber(value))
                throw Error(info.label, "'" + value + "' is no number over 0",
                            std::string("give one like ") + info.usual);
            return;
        case ParameterKind::Choice:
            if (!isOneOf(value, info.type))
                throw Error(info.label, "'" + value + "' is not known", std::string("choose one of ") + info.type);
            return;
    }
}

}  // namespace

const std::vector<ParameterInfo>& parameterTable() {
    using Kind = ParameterKind;
    static const std::vector<ParameterInfo> table{
        {"map_cloud", Kind::Topic, "/rtabmap/cloud_map", "sensor_msgs/PointCloud2", "Map cloud",
         "the map as points; subscribed to only while a map is wanted"},
        {"grid", Kind::Topic, "/map", "nav_msgs/OccupancyGrid", "Grid",
         "what visits are planned on; updates come from the same name with _updates"},
        {"costmap", Kind::Topic, "/move_base/global_costmap/costmap", "nav_msgs/OccupancyGrid", "Cost map",
         "tells the frame of goals, and stands in for a missing grid"},
        {"trajectory", Kind::Topic, "/rtabmap/mapPath", "nav_msgs/Path", "Trajectory",
         "the poses the map was seen from"},
        {"image", Kind::Topic, "/camera/color/image_raw", "sensor_msgs/Image", "Camera image",
         "base name; compressed pictures come from the same name with /compressed"},
        {"image_transport", Kind::Choice, "auto", "auto compressed raw", "Image transport",
         "auto takes compressed pictures where the robot has them"},
        {"camera_info", Kind::Topic, "/camera/color/camera_info", "sensor_msgs/CameraInfo", "Camera calibration", ""},
        {"odometry", Kind::Topic, "/odom", "nav_msgs/Odometry", "Odometry", "tells when the robot stands still"},
        {"move_base", Kind::Topic, "/move_base", "move_base_msgs/MoveBaseAction", "Navigation action",
         "name of the action that goals are sent to"},
        {"cmd_vel", Kind::Topic, "/cmd_vel", "geometry_msgs/Twist", "Speeds", "for driving by hand"},
        {"map_frame", Kind::Frame, "map", "", "Map frame", ""},
        {"odom_frame", Kind::Frame, "odom", "", "Odometry frame", ""},
        {"base_frame", Kind::Frame, "base_footprint", "", "Robot frame", ""},
        {"set_mode_localization", Kind::Service, "/rtabmap/set_mode_localization", "std_srvs/Empty",
         "Localization mode", "the robot stops to change its map"},
        {"set_mode_mapping", Kind::Service, "/rtabmap/set_mode_mapping", "std_srvs/Empty", "Mapping mode",
         "the robot goes on changing its map"},
        {"publish_map", Kind::Service, "/rtabmap/publish_map", "rtabmap_ros/PublishMap", "Publish map",
         "RTAB-Map assembles the map and sends it"},
        {"drive_speed", Kind::Number, "0.15", "m/s", "Greatest speed by hand", ""},
        {"turn_speed", Kind::Number, "0.6", "rad/s", "Greatest turn by hand", ""},
        {"still_speed", Kind::Number, "0.01", "m/s", "Stands still below", "and below as many rad/s, for still_time"},
        {"still_time", Kind::Number, "0.3", "s", "Stands still after", ""},
        {"tf_timeout", Kind::Number, "1.0", "s", "Transforms may be late by", ""},
        {"photo_timeout", Kind::Number, "8.0", "s", "Photo within", "of its being asked for, else the reason is told"},
        {"map_timeout", Kind::Number, "20.0", "s", "Map within", "of its being asked for, else the reason is told"},
        {"lost_after", Kind::Number, "3.0", "s", "Link lost after", "nothing was heard of the robot for this long"},
    };
    return table;
}

ParameterValues::ParameterValues(const std::map<std::string, std::string>& replaced) {
    for (const ParameterInfo& info : parameterTable()) {
        const auto found = replaced.find(info.name);
        const std::string value = found == replaced.end() ? info.usual : found->second;
        requireValid(info, value);
        values_[info.name] = value;
    }
    for (const auto& [name, value] : replaced) {
        if (!values_.contains(name))
            throw Error("robot settings", "'" + name + "' is not known", "take one of the names in the manual");
    }
}

}  // namespace fodscope::bridge
