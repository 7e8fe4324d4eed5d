// SPDX-License-Identifier: MIT
#include "ui/settings/ParameterForm.h"

#include <QFormLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <QVariant>

#include "ui/session/InspectionController.h"
#include "ui/settings/ParameterDraft.h"
#include "ui/settings/ParameterEditor.h"
#include "ui/settings/ParameterWords.h"
#include "ui/theme/Theme.h"

namespace fodscope {
namespace {

/// "Covariance weights" under a heading that says covariance is "Weights".
QString shortName(const ParameterField& field) {
    QString name = parameterName(field);
    const QString prefix = QStringLiteral("Covariance ");
    if (!name.startsWith(prefix)) return name;
    name.remove(0, prefix.size());
    name[0] = name[0].toUpper();
    return name;
}

}  // namespace

ParameterForm::ParameterForm(InspectionController& controller, const std::string& section,
                             const std::vector<std::string>& keys, Relevance matters, QWidget* parent)
    : QWidget(parent), controller_(controller), matters_(std::move(matters)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(12);
    form->setVerticalSpacing(metrics::kStep_px);
    for (const std::string& key : keys) {
        const ParameterField* field = findParameter(section, key);
        if (field == nullptr) continue;
        const QString unit = parameterUnit(*field, controller.state().parameters);
        Row row;
        row.field = field;
        row.name = new QLabel(
            unit.isEmpty() ? shortName(*field) : QStringLiteral("%1 (%2)").arg(shortName(*field), unit), this);
        row.name->setToolTip(parameterHelp(*field));
        row.editor = new ParameterEditor(*field, this);
        form->addRow(row.name, row.editor);
        connect(row.editor, &ParameterEditor::committed, this,
                [this, field](const QString& text) { enter(*field, text); });
        rows_.push_back(row);
    }
    problem_ = new QLabel(this);
    problem_->setWordWrap(true);
    problem_->setProperty("problem", true);
    problem_->hide();
    column->addLayout(form);
    column->addWidget(problem_);
    connect(&controller, &InspectionController::parametersChanged, this, &ParameterForm::refresh);
    connect(&controller, &InspectionController::sessionChanged, this, &ParameterForm::refresh);
    refresh();
}

void ParameterForm::refresh() {
    const Parameters& parameters = controller_.state().parameters;
    problem_->hide();
    for (const Row& row : rows_) {
        row.editor->setText(QString::fromStdString(toString(row.field->get(parameters))));
        row.editor->setInvalid(false);
        const bool matters = !matters_ || matters_(*row.field, parameters);
        row.name->setVisible(matters);
        row.editor->setVisible(matters);
    }
}

void ParameterForm::enter(const ParameterField& field, const QString& text) {
    const Parameters& parameters = controller_.state().parameters;
    ParameterDraft draft(parameters, parameters);
    draft.setText(field, text);
    const QStringList problems = draft.problems();
    for (const Row& row : rows_)
        if (row.field == &field) row.editor->setInvalid(!problems.isEmpty());
    problem_->setText(problems.join(QLatin1Char('\n')));
    problem_->setVisible(!problems.isEmpty());
    if (problems.isEmpty()) controller_.applyParameters(draft.edited());
}

}  // namespace fodscope
