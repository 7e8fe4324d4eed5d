// SPDX-License-Identifier: MIT
#include "ui/session/ParameterUse.h"

#include <algorithm>

#include "core/inspection/ParameterTable.h"

namespace fodscope {

ParameterUse useOf(const std::string& section) {
    if (section == "visits") return ParameterUse::Visits;
    if (section == "occupancy" || section == "cost_map" || section == "waypoints") return ParameterUse::Plan;
    if (section.starts_with("reference") || section.starts_with("covariance")) return ParameterUse::Reference;
    return ParameterUse::Detection;
}

bool sameFor(ParameterUse use, const Parameters& a, const Parameters& b) {
    return std::ranges::all_of(parameterTable(), [&](const ParameterField& field) {
        return useOf(field.section) != use || field.get(a) == field.get(b);
    });
}

}  // namespace fodscope
