// SPDX-License-Identifier: MIT
#include "ui/labelling/ContrastStretch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace fodscope {

namespace {

constexpr double kClippedShare = 0.005;
/// Where the median brightness is lifted or lowered to.
constexpr double kMiddle = 0.42;

using Counts = std::array<std::int64_t, 256>;

Counts brightnessCounts(const QImage& photo) {
    Counts counts{};
    for (int row = 0; row < photo.height(); ++row) {
        const auto* line = reinterpret_cast<const QRgb*>(photo.constScanLine(row));
        for (int column = 0; column < photo.width(); ++column)
            ++counts[static_cast<std::size_t>(qGray(line[column]))];
    }
    return counts;
}

int quantile(const Counts& counts, double share) {
    std::int64_t total = 0;
    for (const std::int64_t count : counts)
        total += count;
    std::int64_t below = 0;
    for (int value = 0; value < 256; ++value) {
        below += counts[static_cast<std::size_t>(value)];
        if (static_cast<double>(below) >= share * static_cast<double>(total)) return value;
    }
    return 255;
}

}  // namespace

QImage contrastStretched(const QImage& photo) {
    if (photo.isNull()) return {};
    QImage stretched = photo.convertToFormat(QImage::Format_RGB32);
    const Counts counts = brightnessCounts(stretched);
    const int low = quantile(counts, kClippedShare);
    const int high = std::max(low + 1, quantile(counts, 1.0 - kClippedShare));
    const double median = std::clamp((quantile(counts, 0.5) - low) / static_cast<double>(high - low), 0.02, 0.98);
    const double gamma = std::clamp(std::log(kMiddle) / std::log(median), 0.4, 2.0);

    std::array<double, 256> gains{};
    for (int value = 0; value < 256; ++value) {
        const double unit = std::clamp((value - low) / static_cast<double>(high - low), 0.0, 1.0);
        gains[static_cast<std::size_t>(value)] = 255.0 * std::pow(unit, gamma) / std::max(1, value);
    }
    const auto scaled = [](int channel, double gain) { return std::min(255, static_cast<int>(channel * gain + 0.5)); };
    for (int row = 0; row < stretched.height(); ++row) {
        auto* line = reinterpret_cast<QRgb*>(stretched.scanLine(row));
        for (int column = 0; column < stretched.width(); ++column) {
            const QRgb pixel = line[column];
            const double gain = gains[static_cast<std::size_t>(qGray(pixel))];
            line[column] = qRgb(scaled(qRed(pixel), gain), scaled(qGreen(pixel), gain), scaled(qBlue(pixel), gain));
        }
    }
    return stretched;
}

}  // namespace fodscope
