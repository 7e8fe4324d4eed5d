// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/inspection/Parameters.h"

namespace fodscope {

/// Parameters by section and key, named as in a parameter file; what is not set is null.
/// @param sections only these; empty: all that an inspection reads, which the settings of references are not
nlohmann::ordered_json jsonParameters(const Parameters& parameters, const std::vector<std::string>& sections = {});

}  // namespace fodscope
