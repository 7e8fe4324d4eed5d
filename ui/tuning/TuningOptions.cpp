// SPDX-License-Identifier: MIT
#include "ui/tuning/TuningOptions.h"

#include <QComboBox>
#include <QDir>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStyle>
#include <QVariant>
#include <algorithm>
#include <cmath>

#include "core/evaluation/PhotoSearch.h"
#include "ui/session/FileDialogs.h"

namespace fodscope {
namespace {

/// A number that somebody typed, with a comma or a point; empty when it is none.
std::optional<double> numberIn(const QLineEdit& field) {
    bool isNumber = false;
    const double value = field.text().trimmed().replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&isNumber);
    if (!isNumber || !std::isfinite(value)) return std::nullopt;
    return value;
}

void markInvalid(QWidget* widget, bool on) {
    widget->setProperty("invalid", on);
    widget->style()->unpolish(widget);
    widget->style()->polish(widget);
}

}  // namespace

TuningOptions::TuningOptions(FileDialogs& files, QWidget* parent) : QWidget(parent), files_(files) {
    form_ = new QFormLayout(this);
    form_->setContentsMargins(0, 0, 0, 0);
    form_->setHorizontalSpacing(12);
    const auto add = [this](const QString& name, auto* field, const char* objectName, const QString& help) {
        field->setObjectName(QString::fromLatin1(objectName));
        field->setToolTip(help);
        form_->addRow(name, field);
        return field;
    };
    objective_ = add(tr("Find"), new QComboBox(this), "tuning.objective",
                     tr("Least cost is the paper's search, which looks at candidates. Fewest photos plans and "
                        "photographs them in the trials' worlds, and takes the least number that shows the wanted "
                        "share of FOD"));
    objective_->addItem(tr("least cost"), static_cast<int>(Objective::Cost));
    objective_->addItem(tr("fewest photos"), static_cast<int>(Objective::Photos));
    metric_ = add(tr("Metric"), new QComboBox(this), "tuning.metric", tr("What the thresholds are thresholds of"));
    lambda_ = add(tr("λ (m)"), new QLineEdit(QString::number(kUnassociatedWeight_m), this), "tuning.lambda",
                  tr("λ: how many metres of distance one superfluous candidate is worth. The paper has 0.05 m"));
    recall_ = add(tr("Recall (%)"), new QLineEdit(QString::number(100.0 * PhotoSearchSettings().recall), this),
                  "tuning.recall", tr("Share of the FOD of all trials that at least one photo has to show"));
    worldsButton_ = add(tr("Worlds"), new QPushButton(this), "tuning.worlds",
                        tr("Folder with the world NAME.json of each trial, in which it is photographed"));
    worldsButton_->setAutoDefault(false);
    connect(worldsButton_, &QPushButton::clicked, this, [this] {
        const QString chosen = files_.chooseFolder(this, tr("Folder of the trials' worlds"), worlds_);
        if (!chosen.isEmpty()) chooseWorlds(chosen);
    });
    for (QLineEdit* field : {lambda_, recall_})
        connect(field, &QLineEdit::textEdited, this, &TuningOptions::refresh);
    for (QComboBox* box : {objective_, metric_})
        connect(box, QOverload<int>::of(&QComboBox::activated), this, &TuningOptions::refresh);
    refresh();
}

TuningOptions::Objective TuningOptions::objective() const {
    return static_cast<Objective>(objective_->currentData().toInt());
}

void TuningOptions::chooseObjective(Objective objective) {
    objective_->setCurrentIndex(objective_->findData(static_cast<int>(objective)));
    refresh();
}

Metric TuningOptions::metric() const {
    return static_cast<Metric>(metric_->currentData().toInt());
}

void TuningOptions::offerMetrics(bool hasCovariance, Metric usual) {
    const QVariant kept = metric_->currentData();
    metric_->clear();
    if (hasCovariance) metric_->addItem(tr("Mahalanobis"), static_cast<int>(Metric::Mahalanobis));
    metric_->addItem(tr("Euclidean"), static_cast<int>(Metric::Euclidean));
    metric_->addItem(tr("Chi-square"), static_cast<int>(Metric::ChiSquare));
    const int index = metric_->findData(kept.isValid() ? kept : QVariant(static_cast<int>(usual)));
    metric_->setCurrentIndex(std::max(0, index));
}

std::optional<double> TuningOptions::lambda_m() const {
    const std::optional<double> value = numberIn(*lambda_);
    return value && *value >= 0.0 ? value : std::nullopt;
}

std::optional<double> TuningOptions::recall() const {
    const std::optional<double> percent = numberIn(*recall_);
    return percent && *percent > 0.0 && *percent <= 100.0 ? std::optional(*percent / 100.0) : std::nullopt;
}

void TuningOptions::chooseWorlds(const QString& folder) {
    worlds_ = folder;
    refresh();
}

QString TuningOptions::obstacle() const {
    if (objective() == Objective::Cost) return lambda_m() ? QString() : tr("λ must be a number of metres, 0 or more");
    if (!recall()) return tr("the recall must be over 0 and at most 100 %");
    if (worlds_.isEmpty()) return tr("choose the folder of the trials' worlds");
    return {};
}

void TuningOptions::refresh() {
    const bool isForPhotos = objective() == Objective::Photos;
    const auto show = [this](QWidget* field, bool on) {
        field->setVisible(on);
        form_->labelForField(field)->setVisible(on);
    };
    show(lambda_, !isForPhotos);
    show(recall_, isForPhotos);
    show(worldsButton_, isForPhotos);
    worldsButton_->setText(worlds_.isEmpty() ? tr("Choose…") : QDir(worlds_).dirName());
    markInvalid(lambda_, !lambda_m());
    markInvalid(recall_, !recall());
    emit changed();
}

}  // namespace fodscope
