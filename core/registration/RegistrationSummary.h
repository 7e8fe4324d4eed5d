// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/registration/Registration.h"

namespace fodscope {

/// A map this many times as large as the reference, or as small, is in other units; no search helps it.
inline constexpr double kAbsurdScale = 20.0;

/// "map origin at x 0.89 m, y 0.73 m, z 0.00 m, turned by 93°": RTAB-Map's origin is where the robot started.
std::string poseInWords(const Transform& T_reference_from_map);

std::string goodSummary(const RegistrationResult& result);
/// The result's alternatives are told with the pose itself.
std::string ambiguousSummary(const RegistrationResult& result);
/// @param scale size of the map over that of the reference
std::string badSummary(const RegistrationResult& result, const RegistrationSettings& settings, double scale);
std::string givenSummary(const RegistrationResult& result, const RegistrationSettings& settings);

}  // namespace fodscope
