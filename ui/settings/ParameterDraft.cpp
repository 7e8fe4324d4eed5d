// SPDX-License-Identifier: MIT
#include "ui/settings/ParameterDraft.h"

#include <QObject>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "ui/session/ParameterUse.h"

namespace fodscope {
namespace {

/// @return the value that a text stands for, whether it is in the field's range or not
std::optional<ParameterValue> valueOf(const ParameterField& field, const QString& typed) {
    const QString text = typed.trimmed();
    switch (field.kind) {
        case ParameterKind::Switch:
            if (text != QLatin1String("true") && text != QLatin1String("false")) return std::nullopt;
            return ParameterValue(text == QLatin1String("true"));
        case ParameterKind::Choice:
            if (std::ranges::find(field.choices, text.toStdString()) == field.choices.end()) return std::nullopt;
            return ParameterValue(text.toStdString());
        case ParameterKind::OptionalNumber:
            if (text.isEmpty() || text == QLatin1String("none")) return ParameterValue();
            break;
        case ParameterKind::Whole:
        case ParameterKind::Number:
            break;
    }
    bool isNumber = false;
    const double number = QString(text).replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&isNumber);
    if (!isNumber || !std::isfinite(number)) return std::nullopt;
    if (field.kind != ParameterKind::Whole) return ParameterValue(number);
    if (number != std::floor(number) || std::abs(number) > std::numeric_limits<int>::max()) return std::nullopt;
    return ParameterValue(static_cast<int>(number));
}

QString fullName(const ParameterField& field) {
    return QStringLiteral("%1.%2").arg(QString::fromStdString(field.section), QString::fromStdString(field.key));
}

std::optional<double> numberOf(const ParameterValue& value) {
    if (const int* whole = std::get_if<int>(&value)) return *whole;
    if (const double* real = std::get_if<double>(&value)) return *real;
    return std::nullopt;
}

}  // namespace

ParameterDraft::ParameterDraft(const Parameters& inEffect, const Parameters& preset, bool isFrozen)
    : inEffect_(inEffect), preset_(preset), edited_(inEffect), isFrozen_(isFrozen) {}

void ParameterDraft::setFrozen(bool isFrozen) {
    isFrozen_ = isFrozen;
    for (const ParameterField& field : parameterTable()) {
        if (!this->isFrozen(field)) continue;
        field.set(edited_, field.get(inEffect_));
        unreadable_.erase(&field);
    }
}

void ParameterDraft::setEdited(const Parameters& parameters) {
    if (!isFrozen_) {
        edited_ = parameters;
        unreadable_.clear();
        return;
    }
    for (const ParameterField& field : parameterTable()) {
        if (isFrozen(field)) continue;
        field.set(edited_, field.get(parameters));
        unreadable_.erase(&field);
    }
}

void ParameterDraft::setText(const ParameterField& field, const QString& text) {
    if (isFrozen(field)) return;
    if (const auto value = valueOf(field, text)) {
        unreadable_.erase(&field);
        if (field.get(edited_) != *value) field.set(edited_, *value);
    } else {
        unreadable_[&field] = text;
    }
}

QString ParameterDraft::text(const ParameterField& field) const {
    if (const auto typed = unreadable_.find(&field); typed != unreadable_.end()) return typed->second;
    return QString::fromStdString(toString(field.get(edited_)));
}

void ParameterDraft::reset(const ParameterField& field) {
    if (isFrozen(field)) return;
    unreadable_.erase(&field);
    field.set(edited_, presetValue(field));
}

void ParameterDraft::usePreset() {
    setEdited(preset_);
}

void ParameterDraft::discard() {
    edited_ = inEffect_;
    unreadable_.clear();
}

ParameterValue ParameterDraft::presetValue(const ParameterField& field) const {
    if (field.section != "candidates" || field.key == "metric") return field.get(preset_);
    // Choosing a metric brings its own usual values, so those are what the preset means for it.
    Parameters comparable = preset_;
    if (const ParameterField* metric = findParameter("candidates", "metric"))
        metric->set(comparable, metric->get(edited_));
    return field.get(comparable);
}

QString ParameterDraft::presetText(const ParameterField& field) const {
    return QString::fromStdString(toString(presetValue(field)));
}

bool ParameterDraft::differsFromPreset(const ParameterField& field) const {
    return unreadable_.contains(&field) || field.get(edited_) != presetValue(field);
}

bool ParameterDraft::isFrozen(const ParameterField& field) const {
    return isFrozen_ && useOf(field.section) != ParameterUse::Visits;
}

QString ParameterDraft::problem(const ParameterField& field) const {
    if (const auto typed = unreadable_.find(&field); typed != unreadable_.end())
        return field.kind == ParameterKind::Whole
                   ? QObject::tr("%1 is \"%2\", which is no whole number").arg(fullName(field), typed->second)
                   : QObject::tr("%1 is \"%2\", which is no number").arg(fullName(field), typed->second);
    const auto number = numberOf(field.get(edited_));
    if (!number || (*number >= field.minimum && *number <= field.maximum)) return {};
    return QObject::tr("allowed is %1 to %2")
        .arg(QString::fromStdString(toString(ParameterValue(field.minimum))),
             QString::fromStdString(toString(ParameterValue(field.maximum))));
}

QStringList ParameterDraft::problems() const {
    QStringList all;
    for (const auto& [field, typed] : unreadable_)
        all << problem(*field);
    for (const std::string& sentence : parameterProblems(edited_))
        all << QString::fromStdString(sentence);
    return all;
}

QString ParameterDraft::obstacle() const {
    if (const int count = static_cast<int>(problems().size()); count > 0)
        return count == 1 ? QObject::tr("one value is wrong, see below")
                          : QObject::tr("%1 values are wrong, see below").arg(count);
    if (!hasChanges()) return QObject::tr("nothing was changed");
    return {};
}

std::string nearestPreset(const Parameters& parameters) {
    std::string best;
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (const std::string& name : presetNames()) {
        const ParameterDraft draft(parameters, presetParameters(name));
        const auto different = static_cast<std::size_t>(std::ranges::count_if(
            parameterTable(), [&](const ParameterField& field) { return draft.differsFromPreset(field); }));
        if (different >= least) continue;
        least = different;
        best = name;
    }
    return best;
}

}  // namespace fodscope
