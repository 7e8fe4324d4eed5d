// SPDX-License-Identifier: MIT
#include "ui/settings/ParameterWords.h"

#include <QCoreApplication>
#include <QStringList>
#include <array>

namespace fodscope {
namespace {

constexpr std::array kUnitEndings = {"_m", "_m2", "_s", "_deg", "_percent", "_cells", "_px"};

QString words(QString text) {
    text.replace(QLatin1Char('_'), QLatin1Char(' ')).replace(QLatin1Char('.'), QStringLiteral(": "));
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    if (text.startsWith(QLatin1String("Cad "))) text.replace(0, 3, QStringLiteral("CAD"));
    return QCoreApplication::translate("Parameters", text.toUtf8().constData());
}

QString number(double value) {
    return QString::fromStdString(toString(ParameterValue(value)));
}

}  // namespace

QString sectionTitle(const std::string& section) {
    return words(QString::fromStdString(section));
}

QString parameterName(const ParameterField& field) {
    QString key = QString::fromStdString(field.key);
    for (const char* ending : kUnitEndings) {
        const QLatin1String unit(ending);
        if (key.endsWith(unit)) return words(key.left(key.size() - unit.size()));
    }
    return words(key);
}

QString parameterUnit(const ParameterField& field, const Parameters& parameters) {
    if (!field.unit.empty())
        return QString::fromStdString(field.unit).replace(QLatin1String("^2"), QStringLiteral("²"));
    if (field.key == "threshold" && parameters.candidates.metric == Metric::Euclidean) return QStringLiteral("m");
    if (field.key.ends_with("_cells")) return QCoreApplication::translate("Parameters", "cells");
    return {};
}

QString parameterMeaning(const ParameterField& field) {
    QString meaning = QCoreApplication::translate("Parameters", field.help.c_str());
    // A symbol that stands alone, such as k, is no word.
    if (meaning.size() > 1 && meaning[1].isLetter()) meaning[0] = meaning[0].toUpper();
    return meaning;
}

QString parameterHelp(const ParameterField& field) {
    QString help = parameterMeaning(field);
    if (field.maximum > field.minimum && field.kind != ParameterKind::Switch)
        help += QCoreApplication::translate("Parameters", "\nAllowed: %1 to %2 %3")
                    .arg(number(field.minimum), number(field.maximum), QString::fromStdString(field.unit))
                    .trimmed();
    return help + QCoreApplication::translate("Parameters", "\nIn a parameter file: %1.%2")
                      .arg(QString::fromStdString(field.section), QString::fromStdString(field.key));
}

bool matchesSearch(const ParameterField& field, const QString& search) {
    const QString text = sectionTitle(field.section) + QLatin1Char(' ') + parameterName(field) + QLatin1Char(' ') +
                         QString::fromStdString(field.key + ' ' + field.help);
    for (const QString& word : search.split(QLatin1Char(' '), Qt::SkipEmptyParts))
        if (!text.contains(word, Qt::CaseInsensitive)) return false;
    return true;
}

}  // namespace fodscope
