// SPDX-License-Identifier: MIT
#include "app/robot_simulator/ros/NodeParameters.h"

#include <xmlrpcpp/XmlRpcValue.h>

#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

namespace fodscope::robot_simulator {
namespace {

using Value = XmlRpc::XmlRpcValue;
using Reader = std::function<void(ModelSettings&, Value&)>;

constexpr double kRadiansPerDegree = 0.017453292519943295;

double number(Value& value) {
    if (value.getType() == Value::TypeInt) return static_cast<int&>(value);
    if (value.getType() == Value::TypeDouble) return static_cast<double&>(value);
    throw std::runtime_error("it is not a number; give one");
}

int integer(Value& value) {
    if (value.getType() != Value::TypeInt) throw std::runtime_error("it is not an integer; give one");
    return static_cast<int&>(value);
}

std::uint64_t seed(Value& value) {
    if (integer(value) < 0) throw std::runtime_error("it is negative; give 0 or more");
    return static_cast<std::uint64_t>(integer(value));
}

bool truth(Value& value) {
    if (value.getType() != Value::TypeBoolean)
        throw std::runtime_error("it is neither true nor false; give one of them");
    return static_cast<bool&>(value);
}

std::string text(Value& value) {
    if (value.getType() != Value::TypeString) throw std::runtime_error("it is not a text; give one");
    return static_cast<std::string&>(value);
}

PlanarPose& start(ModelSettings& settings) {
    if (!settings.start_map) settings.start_map = PlanarPose();
    return *settings.start_map;
}

const std::map<std::string, Reader>& readers() {
    static const std::map<std::string, Reader> table{
        {"world", [](ModelSettings& s, Value& v) { s.world = text(v); }},
        {"fod_seed", [](ModelSettings& s, Value& v) { s.fodSeed = seed(v); }},
        {"seed", [](ModelSettings& s, Value& v) { s.seed = seed(v); }},
        {"mapped", [](ModelSettings& s, Value& v) { s.mapped = truth(v); }},
        {"map_file", [](ModelSettings& s, Value& v) { s.mapFile = text(v); }},
        {"speed", [](ModelSettings& s, Value& v) { s.speed_m_per_s = number(v); }},
        {"turn_speed", [](ModelSettings& s, Value& v) { s.turnSpeed_rad_per_s = number(v); }},
        {"cmd_vel_timeout", [](ModelSettings& s, Value& v) { s.commandTimeout_s = number(v); }},
        {"image_width", [](ModelSettings& s, Value& v) { s.imageWidth_px = integer(v); }},
        {"image_height", [](ModelSettings& s, Value& v) { s.imageHeight_px = integer(v); }},
        {"image_rate", [](ModelSettings& s, Value& v) { s.imageRate_hz = number(v); }},
        {"start_x", [](ModelSettings& s, Value& v) { start(s).x_m = number(v); }},
        {"start_y", [](ModelSettings& s, Value& v) { start(s).y_m = number(v); }},
        {"start_yaw_deg", [](ModelSettings& s, Value& v) { start(s).yaw_rad = kRadiansPerDegree * number(v); }},
        // Read over and over by FaultSource.
        {"faults", [](ModelSettings&, Value&) {}}};
    return table;
}

std::string known() {
    std::string list;
    for (const auto& reader : readers())
        list += (list.empty() ? "" : ", ") + reader.first;
    return list;
}

}  // namespace

ModelSettings withParameters(ModelSettings settings, const ros::NodeHandle& privateNode) {
    Value values;
    if (!privateNode.getParam(privateNode.getNamespace(), values) || values.getType() != Value::TypeStruct)
        return settings;
    for (auto& entry : values) {
        const auto reader = readers().find(entry.first);
        if (reader == readers().end())
            throw std::runtime_error("~" + entry.first + ": no such parameter; the parameters are " + known());
        try {
            reader->second(settings, entry.second);
        } catch (const std::runtime_error& problem) {
            throw std::runtime_error("~" + entry.first + ": " + problem.what());
        }
    }
    return settings;
}

std::vector<std::string> parameterArguments(const ModelSettings& s) {
    std::vector<std::string> arguments;
    const auto add = [&](const char* name, const auto& value) {
        std::ostringstream text;
        text.precision(17);
        text << "_" << name << ":=" << std::boolalpha << value;
        arguments.push_back(text.str());
    };
    add("world", s.world);
    add("fod_seed", s.fodSeed);
    add("seed", s.seed);
    add("mapped", s.mapped);
    if (!s.mapFile.empty()) add("map_file", s.mapFile);
    add("speed", s.speed_m_per_s);
    add("turn_speed", s.turnSpeed_rad_per_s);
    add("cmd_vel_timeout", s.commandTimeout_s);
    add("image_width", s.imageWidth_px);
    add("image_height", s.imageHeight_px);
    add("image_rate", s.imageRate_hz);
    if (s.start_map) {
        add("start_x", s.start_map->x_m);
        add("start_y", s.start_map->y_m);
        add("start_yaw_deg", s.start_map->yaw_rad / kRadiansPerDegree);
    }
    return arguments;
}

}  // namespace fodscope::robot_simulator
