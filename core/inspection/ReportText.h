// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "core/common/UtcTime.h"
#include "core/detection/Discrepancy.h"

namespace fodscope {

/// What stands for a value that nobody recorded.
inline constexpr const char* kNotRecorded = "not recorded";

/// @return the text, or "not recorded" when it is empty
std::string orNotRecorded(const std::string& text);

/// @return the number with that many decimals and a point whatever the locale; "not recorded" when it is not finite
std::string fixed(double value, int decimals);

/// @return whole percent, rounded down: what is nearly all does not become all
std::string percent(double share);

/// @return "8 mm", "34 cm", "1.20 m", by size
std::string length(double value_m);

/// @return "25 × 10 × 6 cm"
std::string sizeText(const Eigen::Vector3d& size_m);

/// @return "x 1.23 m, y 4.56 m, z 0.05 m"
std::string placeText(const Eigen::Vector3d& point_m);

/// @return a discrepancy with its unit: metres as a length, Mahalanobis and chi-square without one
std::string discrepancyText(double value, Metric metric);

/// @return "2026-11-21 10:15 UTC"; "not recorded" for no time
std::string timeText(UtcTime time);

std::string joined(const std::vector<std::string>& words, const std::string& separator);

/// @return "1 finding", "2 findings", "no findings"
std::string counted(std::size_t count, const std::string& one, const std::string& many);

}  // namespace fodscope
