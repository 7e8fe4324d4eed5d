// SPDX-License-Identifier: MIT
#include "core/simulation/RustyPaint.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/simulation/Noise.h"

namespace fodscope {
namespace {

float smoothStep(float low, float high, float value) {
    const float t = std::clamp((value - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

Eigen::Vector3f mix(const Eigen::Vector3f& a, const Eigen::Vector3f& b, float share) {
    return a + (b - a) * share;
}

std::array<float, 256> makeLinearTable() {
    std::array<float, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const float s = static_cast<float>(i) / 255.0f;
        table[i] = s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
    }
    return table;
}

}  // namespace

Eigen::Vector3f linearFromSrgb(Rgb colour) {
    static const std::array<float, 256> table = makeLinearTable();
    return {table[colour.red], table[colour.green], table[colour.blue]};
}

float srgbFromLinear(float value) {
    const float v = std::clamp(value, 0.0f, 1.0f);
    return v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1.0f / 2.4f) - 0.055f;
}

Finish rustyPaint(const Eigen::Vector3f& point_world, const Eigen::Vector3f& normal_world, Rgb paint) {
    constexpr std::uint32_t seed = 1;
    const Eigen::Vector3f base = linearFromSrgb(paint);
    const float brightness = base.maxCoeff();
    const float rusts = smoothStep(0.03f, 0.12f, brightness);
    const float patches = fractalNoise(1.7f * point_world, 3, seed);
    const float blotches = fractalNoise(8.0f * point_world, 5, seed + 100u);
    const float grain = fractalNoise(110.0f * point_world, 3, seed + 200u);
    // Water runs down walls and takes rust along.
    const float upright = 1.0f - std::abs(normal_world.z());
    const Eigen::Vector3f drawnOut(18.0f * point_world.x(), 18.0f * point_world.y(), 1.2f * point_world.z());
    const float streaks = upright > 0.3f ? upright * fractalNoise(drawnOut, 3, seed + 300u) : 0.0f;
    const float wear = 0.65f * patches + 0.60f * blotches + 0.16f * grain + 0.40f * std::max(0.0f, streaks) - 0.06f;
    const float stain = rusts * smoothStep(-0.45f, 0.12f, wear);
    const float rust = rusts * smoothStep(0.10f, 0.17f, wear);
    // Deep in a patch the rust is older and darker than at its rim.
    const float age = smoothStep(0.15f, 0.55f, wear);

    const Eigen::Vector3f oldPaint = base * (0.66f + 0.13f * blotches + 0.06f * grain + 0.07f * patches);
    const Eigen::Vector3f stained = oldPaint.cwiseProduct(Eigen::Vector3f(0.74f, 0.56f, 0.38f));
    const Eigen::Vector3f darkRust(0.032f, 0.014f, 0.008f), brightRust(0.17f, 0.060f, 0.019f);
    const float hue = std::clamp(0.60f - 0.55f * age + 0.50f * grain + 0.25f * blotches, 0.0f, 1.0f);
    Finish finish;
    finish.reflectance =
        mix(mix(oldPaint, stained, 0.85f * stain), mix(darkRust, brightRust, hue), 0.94f * rust).cwiseMax(0.004f);
    finish.shine = 0.05f * (1.0f - rust) + 0.006f;
    finish.gloss = 24.0f;
    return finish;
}

Finish cleanFinish(Rgb colour) {
    Finish finish;
    finish.reflectance = linearFromSrgb(colour).cwiseMax(0.006f);
    finish.shine = 0.10f;
    finish.gloss = 48.0f;
    return finish;
}

}  // namespace fodscope
