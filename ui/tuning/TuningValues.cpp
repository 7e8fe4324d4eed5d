// SPDX-License-Identifier: MIT
#include "ui/tuning/TuningValues.h"

#include <QGridLayout>
#include <QLabel>
#include <QLocale>

#include "core/evaluation/ParameterSearch.h"
#include "ui/panels/Format.h"
#include "ui/theme/Theme.h"

namespace fodscope {
namespace {

QString metres(double value) {
    return QObject::tr("%1 m").arg(QLocale().toString(value, 'f', 3));
}

}  // namespace

TuningValues::TuningValues(QWidget* parent) : QWidget(parent) {
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
    const std::pair<QString, QString> rows[] = {
        {tr("Threshold"), tr("Voxels whose smoothed discrepancy is greater are discrepant")},
        {tr("Cutoff"), tr("Clusters at most this far apart are one candidate")},
        {tr("Least points"), tr("Candidates with fewer voxels are dropped")},
        {tr("Cost"), tr("Mean distance from a FOD to its nearest candidate, plus λ for every candidate that is no "
                        "FOD's nearest one; mean over the trials")},
        {tr("Distance"), tr("Mean distance from a FOD to its nearest candidate; 7.5 m in a trial without candidates")},
        {tr("Unassociated"), tr("Candidates in a trial that are no FOD's nearest one")},
        {tr("Candidates"), tr("Candidates in a trial")}};
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

void TuningValues::fill(std::size_t column, const CandidateSettings& settings, const SearchCost& cost) {
    const QString texts[] = {discrepancyText(settings.threshold, settings.metric),
                             centimetres(settings.clusterCutoff_m),
                             QString::number(settings.minimumPoints),
                             metres(cost.cost),
                             metres(cost.distance_m),
                             QLocale().toString(cost.unassociatedCandidates, 'f', 1),
                             QLocale().toString(cost.candidates, 'f', 1)};
    for (std::size_t i = 0; i < columns_[column].size(); ++i)
        columns_[column][i]->setText(texts[i]);
}

void TuningValues::setChosen(const QString& heading, const CandidateSettings& settings, const SearchCost& cost) {
    heading_->setText(heading);
    fill(0, settings, cost);
}

void TuningValues::setInEffect(const CandidateSettings& settings, const SearchCost& cost) {
    fill(1, settings, cost);
}

}  // namespace fodscope
