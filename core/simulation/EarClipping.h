// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace fodscope {

/// Triangulates a counter-clockwise outline without crossings; it may be concave. A hole is cut in by a bridge that
/// the outline runs along twice. Source: Meisters, "Polygons have ears" (1975).
std::vector<std::array<std::uint32_t, 3>> earClipping(const std::vector<Eigen::Vector2d>& outline);

}  // namespace fodscope
