// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/registration/Registration.h"

namespace fodscope {

/// A number to the micrometre (or the sixth decimal): finer digits are noise, and would differ between machines.
/// @return null for a number that is not finite
nlohmann::ordered_json rounded(double value, int decimals = 6);

nlohmann::ordered_json jsonPoint(const Eigen::Vector3d& point);

/// Four rows of four, to 12 decimals.
nlohmann::ordered_json jsonTransform(const Transform& transform);

/// Overlap, residual and the pose of each pose that fits nearly as well.
nlohmann::ordered_json jsonAlternatives(const std::vector<PoseAlternative>& alternatives);

/// Standard deviations in metres and degrees about the middle of the map, the whole covariance in metres and radians.
/// @return null when it is not known
nlohmann::ordered_json jsonUncertainty(const std::optional<PoseUncertainty>& uncertainty);

/// @return "given", "good", "ambiguous" or "bad"
std::string qualityWord(RegistrationQuality quality);

}  // namespace fodscope
