// SPDX-License-Identifier: MIT
#include "ui/report/ReportStyle.h"

#include <cmath>

namespace fodscope::report {

namespace {

constexpr double kUnitsPerPoint = 254.0 / 72.0;

QFont sized(const char* family, double points, QFont::Weight weight) {
    QFont font(QString::fromLatin1(family));
    font.setStyleHint(QFont::SansSerif);
    font.setPixelSize(static_cast<int>(std::lround(points * kUnitsPerPoint)));
    font.setWeight(weight);
    // Line breaks must not depend on the pixels of a screen.
    font.setHintingPreference(QFont::PreferNoHinting);
    // Any spacing turns ligatures off: a search for "findings" must not miss the ligature of f and i.
    font.setLetterSpacing(QFont::AbsoluteSpacing, 0.1);
    return font;
}

}  // namespace

QFont font(Face face) {
    switch (face) {
        case Face::Body:
            return sized("DejaVu Sans", 8.5, QFont::Normal);
        case Face::Small:
            return sized("DejaVu Sans", 7.0, QFont::Normal);
        case Face::Bold:
            return sized("DejaVu Sans", 8.5, QFont::Bold);
        case Face::Mono:
            return sized("DejaVu Sans Mono", 6.5, QFont::Normal);
        case Face::Heading:
            return sized("DejaVu Sans", 12.5, QFont::Bold);
        case Face::Title:
            return sized("DejaVu Sans", 20.0, QFont::Bold);
        case Face::Statement:
            return sized("DejaVu Sans", 10.0, QFont::Normal);
    }
    return {};
}

const Theme& colours() {
    static const Theme theme = makeTheme(ThemeKind::Light);
    return theme;
}

}  // namespace fodscope::report
