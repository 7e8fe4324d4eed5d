// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/inspection/Parameters.h"

namespace fodscope {

/// monostate: not set (only where a parameter is optional).
using ParameterValue = std::variant<std::monostate, bool, int, double, std::string>;

enum class ParameterKind { Switch, Whole, Number, OptionalNumber, Choice };

/// One parameter as people and files see it. Angles are in degrees here, in radians in the record.
struct ParameterField {
    std::string section;
    std::string key;
    /// "m", "s", "deg", "%", or empty.
    std::string unit;
    std::string help;
    ParameterKind kind = ParameterKind::Number;
    /// Range of numbers, both ends allowed.
    double minimum = 0.0;
    double maximum = 0.0;
    /// The words of a choice.
    std::vector<std::string> choices;
    std::function<ParameterValue(const Parameters&)> get;
    /// Expects a value of the field's kind and in its range.
    std::function<void(Parameters&, const ParameterValue&)> set;
};

/// The section about how references are made, which an inspection does not read: reports leave it out, since they
/// cannot know that their reference was made so.
inline constexpr const char* kReferenceSection = "reference";

/// Every parameter of every stage, in the order of the file. Reader, writer and range checks all rest on it.
std::span<const ParameterField> parameterTable();

/// @return null for an unknown one
const ParameterField* findParameter(const std::string& section, const std::string& key);

/// @return what is wrong with a whole record, one sentence each: values out of range and values that contradict each
///         other
std::vector<std::string> parameterProblems(const Parameters& parameters);

/// @return as text: "0.02", "true", "mahalanobis", "none"
std::string toString(const ParameterValue& value);

}  // namespace fodscope
