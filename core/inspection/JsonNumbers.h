// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/registration/Registration.h"

namespace fodscope {

/// A number to the micrometre (or the sixth decimal): finer digits are noise, and would differ between machines.
/// @return null for a number that is not finite
nlohmann::ordered_json rounded(double value, int decimals = 6);

nlohmann::ordered_json jsonPoint(const Eigen::Vector3d& point);

/// Four rows of four, to 12 decimals.
nlohmann::ordered_json jsonTransform(const Transform& transform);

/// @return "given", "good" or "bad"
std::string qualityWord(RegistrationQuality quality);

}  // namespace fodscope
