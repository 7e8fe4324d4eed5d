// SPDX-License-Identifier: MIT
#include "app/ros1_bridge/StreamTable.h"

#include <algorithm>

namespace fodscope::bridge {

StreamTable::StreamTable(const ParameterValues& parameters) {
    const auto add = [this](const char* name, const std::string& topic, const char* type, double staleAfter_s,
                            bool isLifeSign) {
        entries_.push_back({{name, topic, type, std::nullopt, staleAfter_s, 0, ""}, isLifeSign, std::nullopt});
    };
    const auto text = [&](const char* name) { return parameters.text(name); };
    add("transforms", "/tf", "tf2_msgs/TFMessage", 1.0, true);
    add("odometry", text("odometry"), "nav_msgs/Odometry", 1.0, true);
    add("navigation", text("move_base") + "/status", "actionlib_msgs/GoalStatusArray", 2.0, true);
    add("camera", text("image"), "sensor_msgs/Image", 2.0, false);
    add("camera calibration", text("camera_info"), "sensor_msgs/CameraInfo", 2.0, false);
    add("grid", text("grid"), "nav_msgs/OccupancyGrid", 0.0, false);
    add("cost map", text("costmap"), "nav_msgs/OccupancyGrid", 0.0, false);
    add("map cloud", text("map_cloud"), "sensor_msgs/PointCloud2", 0.0, false);
    add("trajectory", text("trajectory"), "nav_msgs/Path", 0.0, false);
}

StreamTable::Entry& StreamTable::entry(const std::string& name) {
    return *std::find_if(entries_.begin(), entries_.end(), [&](const Entry& each) { return each.stream.name == name; });
}

void StreamTable::heard(const std::string& name, double now_s) {
    Entry& each = entry(name);
    each.heard_s = now_s;
    ++each.stream.count;
}

void StreamTable::setNote(const std::string& name, const std::string& note) {
    entry(name).stream.note = note;
}

void StreamTable::setTopic(const std::string& name, const std::string& topic, const std::string& type) {
    entry(name).stream.topic = topic;
    entry(name).stream.type = type;
}

std::optional<double> StreamTable::lifeSign_s() const {
    std::optional<double> newest;
    for (const Entry& each : entries_) {
        if (each.isLifeSign && each.heard_s && (!newest || *each.heard_s > *newest)) newest = each.heard_s;
    }
    return newest;
}

Streams StreamTable::at(double now_s) const {
    Streams streams;
    for (const Entry& each : entries_) {
        streams.streams.push_back(each.stream);
        if (each.heard_s) streams.streams.back().age_s = std::max(0.0, now_s - *each.heard_s);
    }
    return streams;
}

}  // namespace fodscope::bridge
