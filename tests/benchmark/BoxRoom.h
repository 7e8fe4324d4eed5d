// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace fodscope {

/// Points on the walls of a box room with a centimetre of noise, as dense as a map of a tank: about a point a square
/// centimetre, whatever their number; the room grows with it.
std::vector<Eigen::Vector3d> boxRoom(std::size_t count, std::uint64_t seed);

}  // namespace fodscope
