// SPDX-License-Identifier: MIT
#include "ui/theme/Colours.h"

#include <QString>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/theme/Viridis.h"

namespace fodscope {
namespace {

// Okabe and Ito 2008 without black, which no dark surface shows; a neutral grey takes its place.
constexpr std::array<QRgb, kCandidateColours> kOkabeIto = {
    qRgb(0xE6, 0x9F, 0x00), qRgb(0x56, 0xB4, 0xE9), qRgb(0x00, 0x9E, 0x73), qRgb(0xF0, 0xE4, 0x42),
    qRgb(0x00, 0x72, 0xB2), qRgb(0xD5, 0x5E, 0x00), qRgb(0xCC, 0x79, 0xA7), qRgb(0x99, 0x99, 0x99)};

/// ColorBrewer's RdBu of seven (Apache 2.0, C. Brewer), from blue to red.
constexpr std::array<QRgb, 7> kRedBlue = {qRgb(0x21, 0x66, 0xAC), qRgb(0x67, 0xA9, 0xCF), qRgb(0xD1, 0xE5, 0xF0),
                                          qRgb(0xF7, 0xF7, 0xF7), qRgb(0xFD, 0xDB, 0xC7), qRgb(0xEF, 0x8A, 0x62),
                                          qRgb(0xB2, 0x18, 0x2B)};

}  // namespace

QColor candidateColour(int index) {
    const int wrapped = ((index % kCandidateColours) + kCandidateColours) % kCandidateColours;
    return QColor(kOkabeIto[static_cast<std::size_t>(wrapped)]);
}

QColor candidateColour(const QString& candidateId) {
    const int dash = candidateId.lastIndexOf(QLatin1Char('-'));
    bool isNumber = false;
    const int number = candidateId.mid(dash + 1).toInt(&isNumber);
    if (isNumber) return candidateColour(number - 1);
    uint sum = 0;
    for (const QChar character : candidateId)
        sum = sum * 31 + character.unicode();
    return candidateColour(static_cast<int>(sum % kCandidateColours));
}

QColor viridis(double t) {
    if (std::isnan(t)) return {};
    const double position = std::clamp(t, 0.0, 1.0) * (kViridis.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(position), kViridis.size() - 2);
    const double share = position - static_cast<double>(below);
    return mixed(QColor(QRgb(kViridis[below])), QColor(QRgb(kViridis[below + 1])), share);
}

QColor diverging(double t) {
    if (std::isnan(t)) return {};
    const double position = std::clamp(t, 0.0, 1.0) * (kRedBlue.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(position), kRedBlue.size() - 2);
    return mixed(QColor(kRedBlue[below]), QColor(kRedBlue[below + 1]), position - static_cast<double>(below));
}

QColor mixed(const QColor& a, const QColor& b, double share) {
    const auto mix = [share](double from, double to) { return from + (to - from) * share; };
    return QColor::fromRgbF(mix(a.redF(), b.redF()), mix(a.greenF(), b.greenF()), mix(a.blueF(), b.blueF()),
                            mix(a.alphaF(), b.alphaF()));
}

}  // namespace fodscope
