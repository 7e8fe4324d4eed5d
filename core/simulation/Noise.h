// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace fodscope {

/// Smooth gradient noise in space, about −1…1, the same for the same point and seed.
float gradientNoise(const Eigen::Vector3f& point, std::uint32_t seed);

/// Octaves of gradient noise, each at twice the frequency and half the amplitude; about −1…1.
float fractalNoise(Eigen::Vector3f point, int octaves, std::uint32_t seed);

}  // namespace fodscope
