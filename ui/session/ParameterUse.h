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

}  // namespace fodscope
