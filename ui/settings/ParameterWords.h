// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include "core/inspection/ParameterTable.h"

namespace fodscope {

/// "cost_map" → "Cost map"
QString sectionTitle(const std::string& section);
/// "map_voxel_size_m" → "Map voxel size": the unit stands beside the value.
QString parameterName(const ParameterField& field);
/// The unit of a value in this record: a threshold is in metres for one metric and without unit for another.
QString parameterUnit(const ParameterField& field, const Parameters& parameters);
/// What it does, in a sentence.
QString parameterMeaning(const ParameterField& field);
/// That with its range and its name in a parameter file, for a tool tip.
QString parameterHelp(const ParameterField& field);
/// @return whether every word of the search is in the parameter's section, name or help; all for an empty search
bool matchesSearch(const ParameterField& field, const QString& search);

}  // namespace fodscope
