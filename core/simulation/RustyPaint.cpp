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
    const float blotches = fractalNoise(9.0f * point_world, 4, seed + 100u);
    const float grain = fractalNoise(95.0f * point_world, 2, seed + 200u);
    // Water runs down walls and takes rust along.
    const float upright = 1.0f - std::abs(normal_world.z());
    const Eigen::Vector3f drawnOut(16.0f * point_world.x(), 16.0f * point_world.y(), 1.3f * point_world.z());
    const float streaks = upright > 0.3f ? upright * fractalNoise(drawnOut, 2, seed + 300u) : 0.0f;
    const float wear = 0.60f * patches + 0.55f * blotches + 0.12f * grain + 0.30f * std::max(0.0f, streaks) - 0.10f;
    const float stain = rusts * smoothStep(-0.35f, 0.15f, wear);
    const float rust = rusts * smoothStep(0.10f, 0.20f, wear);

    const Eigen::Vector3f oldPaint = base * (0.82f + 0.10f * blotches + 0.06f * grain);
    const Eigen::Vector3f stained = oldPaint.cwiseProduct(Eigen::Vector3f(0.78f, 0.62f, 0.44f));
    const Eigen::Vector3f darkRust(0.045f, 0.018f, 0.009f), brightRust(0.20f, 0.075f, 0.022f);
    const float hue = std::clamp(0.42f + 0.45f * grain + 0.35f * blotches, 0.0f, 1.0f);
    Finish finish;
    finish.reflectance =
        mix(mix(oldPaint, stained, 0.75f * stain), mix(darkRust, brightRust, hue), 0.93f * rust).cwiseMax(0.004f);
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
