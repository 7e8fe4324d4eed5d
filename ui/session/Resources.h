// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace fodscope {

/// @param name below resources/, e.g. "labels/fod.yaml"
/// @return where it is: beside the installed program, else in the sources it was built from
/// @throws Error when it is in neither
std::filesystem::path resourceFile(const std::string& name);

}  // namespace fodscope
