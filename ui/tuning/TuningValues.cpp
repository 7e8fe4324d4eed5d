// SPDX-License-Identifier: MIT
#include "ui/tuning/TuningValues.h"

#include <QGridLayout>
#include <QLabel>

#include "core/detection/Candidates.h"
#include "ui/panels/Format.h"
#include "ui/theme/Theme.h"

namespace fodscope {

TuningValues::TuningValues(const std::vector<Row>& outcome, QWidget* parent) : QWidget(parent) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(12);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(0, 1);
    const auto header = [&](const QString& text, int column) {
        auto* label = new QLabel(text, this);
        setTextRole(label, TextRole::Muted);
        grid->addWidget(label, 0, column, Qt::AlignRight);
        return label;
    };
    heading_ = header(tr("best"), 1);
    header(tr("in effect"), 2);
    std::vector<Row> rows{{tr("Threshold"), tr("Voxels whose smoothed discrepancy is greater are discrepant")},
                          {tr("Cutoff"), tr("Clusters at most this far apart are one candidate")},
                          {tr("Least points"), tr("Candidates with fewer voxels are dropped")}};
    rows.insert(rows.end(), outcome.begin(), outcome.end());
    int row = 1;
    for (const auto& [name, help] : rows) {
        auto* label = new QLabel(name, this);
        label->setToolTip(help);
        grid->addWidget(label, row, 0);
        for (int column = 0; column < 2; ++column) {
            auto* value = new QLabel(QStringLiteral("–"), this);
            value->setObjectName(QStringLiteral("tuning.value.%1.%2").arg(column).arg(row));
            value->setToolTip(help);
            setTextRole(value, column == 0 ? TextRole::Emphasis : TextRole::Body);
            value->setTextInteractionFlags(Qt::TextSelectableByMouse);
            grid->addWidget(value, row, column + 1, Qt::AlignRight);
            columns_[column].push_back(value);
        }
        ++row;
    }
}

void TuningValues::fill(std::size_t column, const CandidateSettings& settings, const QStringList& outcome) {
    const QStringList texts =
        QStringList{discrepancyText(settings.threshold, settings.metric), centimetres(settings.clusterCutoff_m),
                    QString::number(settings.minimumPoints)} +
        outcome;
    for (std::size_t i = 0; i < columns_[column].size(); ++i)
        columns_[column][i]->setText(texts.value(static_cast<int>(i), QStringLiteral("–")));
}

void TuningValues::setChosen(const QString& heading, const CandidateSettings& settings, const QStringList& outcome) {
    heading_->setText(heading);
    fill(0, settings, outcome);
}

void TuningValues::setInEffect(const CandidateSettings& settings, const QStringList& outcome) {
    fill(1, settings, outcome);
}

}  // namespace fodscope
