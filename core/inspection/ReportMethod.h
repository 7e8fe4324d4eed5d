// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/inspection/Parameters.h"

namespace fodscope {

/// @return how candidates came about with these parameters, as a paragraph of the report
std::string methodOf(const Parameters& parameters);

}  // namespace fodscope
