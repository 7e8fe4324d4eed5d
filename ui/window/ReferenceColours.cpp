// SPDX-License-Identifier: MIT
#include "ui/window/ReferenceColours.h"

#include <QLocale>

#include "core/reference/LogDeterminant.h"
#include "ui/panels/Format.h"

namespace fodscope {
namespace {

/// One colour means one residual all day.
constexpr double kShownResidual_m = 0.02;

}  // namespace

ReferenceColours covarianceColours(const ReferenceMap& reference) {
    ReferenceColours colours;
    colours.values = logDeterminants(reference);
    ScalarStyle& style = colours.style;
    style.title = QObject::tr("log det Σ (m⁶)");
    style.decimals = 1;
    style.reachesBelow = true;
    style.unknownWord = QObject::tr("without training");
    style.stripesUnknown = true;
    style.describe = [](double value) {
        return QObject::tr("log det Σ %1: the maps vary by %2 here")
            .arg(QLocale().toString(value, 'f', 1), spreadText(value));
    };
    if (const auto range = heatMapRange(colours.values)) {
        style.minimum = range->low;
        style.maximum = range->high;
    }
    return colours;
}

ReferenceColours residualColours(const RegionResiduals& residuals) {
    ReferenceColours colours;
    colours.values = residuals.offsetOfPoints_m();
    ScalarStyle& style = colours.style;
    style.title = QObject::tr("Residual");
    style.unit = QStringLiteral("mm");
    style.displayFactor = 1000.0;
    style.decimals = 0;
    style.minimum = -kShownResidual_m;
    style.maximum = kShownResidual_m;
    style.scale = ColourScale::Diverging;
    style.reachesBelow = true;
    style.unknownWord = QObject::tr("not measured");
    style.stripesUnknown = true;
    style.describe = [](double offset_m) {
        return offset_m < 0.0 ? QObject::tr("%1 outwards").arg(millimetres(-offset_m, 0))
                              : QObject::tr("%1 inwards").arg(millimetres(offset_m, 0));
    };
    return colours;
}

}  // namespace fodscope
