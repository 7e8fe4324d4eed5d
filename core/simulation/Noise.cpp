// SPDX-License-Identifier: MIT
#include "core/simulation/Noise.h"

#include <cmath>

namespace fodscope {
namespace {

std::uint32_t hashCell(std::int32_t x, std::int32_t y, std::int32_t z, std::uint32_t seed) {
    std::uint32_t h = seed * 0x9e3779b1u;
    h ^= static_cast<std::uint32_t>(x) * 0x85ebca6bu;
    h ^= static_cast<std::uint32_t>(y) * 0xc2b2ae35u;
    h ^= static_cast<std::uint32_t>(z) * 0x27d4eb2fu;
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 12;
    h *= 0x297a2d39u;
    h ^= h >> 15;
    return h;
}

/// Dot product with one of Perlin's twelve edge gradients.
float gradientDot(std::uint32_t hash, float x, float y, float z) {
    const std::uint32_t h = hash & 15u;
    const float u = h < 8 ? x : y;
    const float v = h < 4 ? y : (h == 12 || h == 14 ? x : z);
    return ((h & 1u) ? -u : u) + ((h & 2u) ? -v : v);
}

float fade(float t) {
    return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

float lerp(float a, float b, float t) {
    return a + (b - a) * t;
}

}  // namespace

float gradientNoise(const Eigen::Vector3f& point, std::uint32_t seed) {
    const float fx = std::floor(point.x()), fy = std::floor(point.y()), fz = std::floor(point.z());
    const auto ix = static_cast<std::int32_t>(fx), iy = static_cast<std::int32_t>(fy),
               iz = static_cast<std::int32_t>(fz);
    const float x = point.x() - fx, y = point.y() - fy, z = point.z() - fz;
    const float u = fade(x), v = fade(y), w = fade(z);
    const auto corner = [&](int dx, int dy, int dz) {
        return gradientDot(hashCell(ix + dx, iy + dy, iz + dz, seed), x - static_cast<float>(dx),
                           y - static_cast<float>(dy), z - static_cast<float>(dz));
    };
    const float near = lerp(lerp(corner(0, 0, 0), corner(1, 0, 0), u), lerp(corner(0, 1, 0), corner(1, 1, 0), u), v);
    const float far = lerp(lerp(corner(0, 0, 1), corner(1, 0, 1), u), lerp(corner(0, 1, 1), corner(1, 1, 1), u), v);
    return lerp(near, far, w);
}

float fractalNoise(Eigen::Vector3f point, int octaves, std::uint32_t seed) {
    float sum = 0.0f;
    float amplitude = 1.0f;
    float total = 0.0f;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += amplitude * gradientNoise(point, seed + static_cast<std::uint32_t>(octave));
        total += amplitude;
        amplitude *= 0.5f;
        // The shift keeps the zero crossings of the octaves at the lattice points from coinciding.
        point = 2.03f * point + Eigen::Vector3f(17.1f, 9.2f, 5.7f);
    }
    return total > 0.0f ? 1.6f * sum / total : 0.0f;
}

}  // namespace fodscope
