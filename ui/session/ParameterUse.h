// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/inspection/Parameters.h"

namespace fodscope {

/// What a section's parameters are for, and so what has to be made anew when one of them changes.
enum class ParameterUse { Reference, Detection, Plan, Visits };
ParameterUse useOf(const std::string& section);

/// @return whether the parameters of that use are equal in both
bool sameFor(ParameterUse use, const Parameters& a, const Parameters& b);

/// @return the preset whose detection a record has, in the metric of the record; empty: a detection of its own
std::string detectionPresetOf(const Parameters& parameters);

/// @return the parameters with all of a preset's detection. Without covariances the metric is the Euclidean one, with
///         the preset's usual values for it.
Parameters withDetectionPreset(const Parameters& parameters, const std::string& preset, bool hasCovariance);

}  // namespace fodscope
