// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

/// What can be set about a robot that speaks ROS 1. This header is C++17: files that include ROS read it.
namespace fodscope::bridge {

enum class ParameterKind { Topic, Frame, Service, Number, Choice };

struct ParameterInfo {
    /// "map_cloud"
    const char* name;
    ParameterKind kind;
    /// What an ordinary robot with RTAB-Map and move_base has.
    const char* usual;
    /// Type of a topic's messages, unit of a number, words of a choice separated by blanks.
    const char* type;
    /// For people.
    const char* label;
    const char* help;
};

/// All of them, in the order in which they are shown.
const std::vector<ParameterInfo>& parameterTable();

/// Values by name, checked.
class ParameterValues {
  public:
    /// The usual values with some replaced.
    /// @throws Error for a name that is not in the table, a topic or frame that ROS does not allow, or a number that is
    ///         none or not over 0
    explicit ParameterValues(const std::map<std::string, std::string>& replaced = {});

    const std::string& text(const std::string& name) const { return values_.at(name); }
    double number(const std::string& name) const { return std::stod(values_.at(name)); }

  private:
    std::map<std::string, std::string> values_;
};

}  // namespace fodscope::bridge
