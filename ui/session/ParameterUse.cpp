// SPDX-License-Identifier: MIT
#include "ui/session/ParameterUse.h"

#include <algorithm>

#include "core/inspection/ParameterTable.h"

namespace fodscope {

ParameterUse useOf(const std::string& section) {
    if (section == "visits") return ParameterUse::Visits;
    if (section == "occupancy" || section == "cost_map" || section == "camera" || section == "waypoints")
        return ParameterUse::Plan;
    if (section.starts_with("reference") || section.starts_with("covariance")) return ParameterUse::Reference;
    return ParameterUse::Detection;
}

bool sameFor(ParameterUse use, const Parameters& a, const Parameters& b) {
    return std::ranges::all_of(parameterTable(), [&](const ParameterField& field) {
        return useOf(field.section) != use || field.get(a) == field.get(b);
    });
}

namespace {

Parameters inMetric(Parameters parameters, Metric metric) {
    if (parameters.candidates.metric != metric) parameters.candidates = usualCandidateSettings(metric, parameters);
    return parameters;
}

}  // namespace

std::string detectionPresetOf(const Parameters& parameters) {
    for (const std::string& name : presetNames())
        if (sameFor(ParameterUse::Detection, inMetric(presetParameters(name), parameters.candidates.metric),
                    parameters))
            return name;
    return {};
}

Parameters withDetectionPreset(const Parameters& parameters, const std::string& preset, bool hasCovariance) {
    Parameters wanted = presetParameters(preset);
    if (!hasCovariance && wanted.candidates.metric == Metric::Mahalanobis) wanted = inMetric(wanted, Metric::Euclidean);
    Parameters result = parameters;
    for (const ParameterField& field : parameterTable())
        if (useOf(field.section) == ParameterUse::Detection) field.set(result, field.get(wanted));
    return result;
}

}  // namespace fodscope
