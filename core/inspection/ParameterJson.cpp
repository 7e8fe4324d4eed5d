// SPDX-License-Identifier: MIT
#include "core/inspection/ParameterJson.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/inspection/JsonNumbers.h"
#include "core/inspection/ParameterTable.h"

namespace fodscope {
namespace {

using Json = nlohmann::ordered_json;

Json jsonOf(const ParameterValue& value) {
    if (const auto* flag = std::get_if<bool>(&value)) return *flag;
    if (const auto* whole = std::get_if<int>(&value)) return *whole;
    if (const auto* real = std::get_if<double>(&value)) return rounded(*real, 9);
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    return nullptr;
}

}  // namespace

Json jsonParameters(const Parameters& parameters, const std::vector<std::string>& sections) {
    Json json = Json::object();
    for (const ParameterField& field : parameterTable()) {
        const bool wanted = sections.empty() ? field.section != kReferenceSection
                                             : std::ranges::find(sections, field.section) != sections.end();
        if (wanted) json[field.section][field.key] = jsonOf(field.get(parameters));
    }
    return json;
}

}  // namespace fodscope
