// SPDX-License-Identifier: MIT
#include "ui/settings/SettingsRow.h"

#include <QGridLayout>
#include <QLabel>
#include <QStyle>
#include <QToolButton>

#include "ui/settings/ParameterDraft.h"
#include "ui/settings/ParameterEditor.h"
#include "ui/settings/ParameterWords.h"
#include "ui/theme/Icons.h"
#include "ui/theme/Theme.h"

namespace fodscope {
namespace {

constexpr int kEditorWidth_px = 152;

}  // namespace

SettingsRow::SettingsRow(const ParameterField& field, QGridLayout& grid, int row, QWidget* parent)
    : QObject(parent), field_(field) {
    const QString id =
        QStringLiteral("%1.%2").arg(QString::fromStdString(field.section), QString::fromStdString(field.key));
    name_ = new QLabel(parameterName(field), parent);
    name_->setToolTip(parameterHelp(field));
    name_->setWordWrap(true);
    editor_ = new ParameterEditor(field, parent);
    editor_->setFixedWidth(kEditorWidth_px);
    name_->setBuddy(editor_);
    unit_ = new QLabel(parent);
    setTextRole(unit_, TextRole::Muted);
    note_ = new QLabel(parent);
    note_->setObjectName(QStringLiteral("note.") + id);
    note_->setTextFormat(Qt::PlainText);
    note_->setWordWrap(true);
    setTextRole(note_, TextRole::Caption);
    reset_ = new QToolButton(parent);
    reset_->setObjectName(QStringLiteral("reset.") + id);
    reset_->setIcon(icon(Icon::Retry));
    reset_->setAccessibleName(tr("Back to the preset's value: %1").arg(parameterName(field)));
    keepResetsPlace(true);

    grid.addWidget(name_, row, 0);
    grid.addWidget(editor_, row, 1);
    grid.addWidget(unit_, row, 2);
    grid.addWidget(reset_, row, 3);
    grid.addWidget(note_, row, 4);
    connect(editor_, &ParameterEditor::edited, this, &SettingsRow::edited);
    connect(reset_, &QToolButton::clicked, this, &SettingsRow::resetAsked);
}

void SettingsRow::show(const ParameterDraft& draft) {
    editor_->setText(draft.text(field_));
    unit_->setText(parameterUnit(field_, draft.edited()));
    const QString problem = draft.problem(field_);
    editor_->setInvalid(!problem.isEmpty());
    const bool frozen = draft.isFrozen(field_);
    editor_->setEnabled(!frozen);
    const bool differs = draft.differsFromPreset(field_);
    reset_->setVisible(!name_->isHidden() && differs && !frozen);
    reset_->setToolTip(tr("Back to %1").arg(draft.presetText(field_)));
    const QString preset = differs ? tr("preset: %1. ").arg(draft.presetText(field_)) : QString();
    note_->setText(problem.isEmpty() ? preset + parameterMeaning(field_) : problem);
}

void SettingsRow::setVisible(bool visible) {
    for (QWidget* widget : {static_cast<QWidget*>(name_), static_cast<QWidget*>(editor_), static_cast<QWidget*>(unit_),
                            static_cast<QWidget*>(note_)})
        widget->setVisible(visible);
    // A row that the search hides must not leave a gap.
    keepResetsPlace(visible);
    if (!visible) reset_->hide();
}

void SettingsRow::keepResetsPlace(bool kept) {
    QSizePolicy policy = reset_->sizePolicy();
    policy.setRetainSizeWhenHidden(kept);
    reset_->setSizePolicy(policy);
}

}  // namespace fodscope
