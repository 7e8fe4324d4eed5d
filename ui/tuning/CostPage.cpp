// SPDX-License-Identifier: MIT
#include "ui/tuning/CostPage.h"

#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/panels/Format.h"
#include "ui/panels/PanelParts.h"
#include "ui/tuning/CostSurface.h"
#include "ui/tuning/TuningValues.h"
#include "ui/widgets/ValueSlider.h"

namespace fodscope {
namespace {

AxisStyle thresholdAxis(Metric metric) {
    if (metric == Metric::Euclidean) return {QObject::tr("threshold"), QStringLiteral("mm"), 1000.0, 1};
    return {QObject::tr("threshold"), {}, 1.0, metric == Metric::Mahalanobis ? 2 : 0};
}

QStringList costTexts(const SearchCost& cost) {
    const auto metres = [](double value) { return QObject::tr("%1 m").arg(QLocale().toString(value, 'f', 3)); };
    return {metres(cost.cost), metres(cost.distance_m), QLocale().toString(cost.unassociatedCandidates, 'f', 1),
            QLocale().toString(cost.candidates, 'f', 1)};
}

}  // namespace

CostPage::CostPage(QWidget* parent) : TuningPage(parent) {
    values_ = new TuningValues({
        {tr("Cost"), tr("Mean distance from a FOD to its nearest candidate, plus λ for every candidate that is no "
                        "FOD's nearest one; mean over the trials")},
        {tr("Distance"), tr("Mean distance from a FOD to its nearest candidate; 7.5 m in a trial without candidates")},
        {tr("Unassociated"), tr("Candidates in a trial that are no FOD's nearest one")},
        {tr("Candidates"), tr("Candidates in a trial")},
    });
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    surface_ = new CostSurface(this);
    surface_->setObjectName(QStringLiteral("tuning.surface"));
    reading_ = makeText({}, TextRole::Body, this);
    reading_->setObjectName(QStringLiteral("tuning.reading"));
    leastPoints_ = new ValueSlider(tr("Least points of a candidate"), {0.0, 9.0, 1.0, 3.0, tr("voxels"), 1.0, 0}, this);
    leastPoints_->setObjectName(QStringLiteral("tuning.leastPoints"));
    leastPoints_->setHelp(tr("The picture shows the costs at this count; the colours mean the same at every count."));
    leastPoints_->setEnabled(false);
    column->addWidget(surface_, 1);
    column->addWidget(reading_);
    column->addWidget(leastPoints_);
    connect(surface_, &CostSurface::cellHovered, this, &CostPage::read);
    connect(surface_, &CostSurface::cellChosen, this, &CostPage::choose);
    connect(leastPoints_, &ValueSlider::valueChanging, this, &CostPage::showLeastPoints);
    connect(leastPoints_, &ValueSlider::valueCommitted, this, &CostPage::showLeastPoints);
}

void CostPage::showOutcome(const TuningOutcome& outcome) {
    outcome_ = outcome;
    const ParameterSearchResult& result = outcome_->result;
    values_->setInEffect(outcome_->inEffect, costTexts(outcome_->costInEffect));
    surface_->setAxes({tr("cluster cutoff"), QStringLiteral("cm"), 100.0, 0}, thresholdAxis(result.settings.metric));
    leastPoints_->setEnabled(true);
    leastPoints_->setRange({static_cast<double>(result.leastPoints.front()),
                            static_cast<double>(result.leastPoints.back()), 1.0, 3.0, tr("voxels"), 1.0, 0});
    chooseBest();
}

std::optional<CandidateSettings> CostPage::chosen() const {
    if (!outcome_) return std::nullopt;
    return settingsAt(outcome_->result, chosen_);
}

void CostPage::chooseBest() {
    if (!outcome_) return;
    chosen_ = outcome_->result.best;
    leastPoints_->setValue(outcome_->result.leastPoints[chosen_.leastPoints]);
    showLeastPoints();
}

void CostPage::markInEffect(const CandidateSettings& settings) {
    if (outcome_ && settings.metric == outcome_->result.settings.metric)
        surface_->setCurrent(settings.clusterCutoff_m, settings.threshold);
}

std::size_t CostPage::leastIndex() const {
    const std::vector<int>& counts = outcome_->result.leastPoints;
    const auto wanted = std::ranges::find(counts, static_cast<int>(std::lround(leastPoints_->value())));
    return wanted == counts.end() ? 0 : static_cast<std::size_t>(wanted - counts.begin());
}

void CostPage::showLeastPoints() {
    if (!outcome_) return;
    const CostGrid grid = costGridOf(outcome_->result, leastIndex());
    surface_->setGrid(grid, costRangeOf(outcome_->result));
    surface_->setBest(cheapestCell(grid));
    choose({chosen_.cutoff, chosen_.threshold});
    read(std::nullopt);
}

void CostPage::choose(const CostCell& cell) {
    if (!outcome_) return;
    const ParameterSearchResult& result = outcome_->result;
    chosen_ = {cell.cutoff, cell.threshold, leastIndex()};
    surface_->setChosen(cell);
    values_->setChosen(chosen_ == result.best ? tr("best") : tr("chosen"), settingsAt(result, chosen_),
                       costTexts(result.at(chosen_)));
    emit chosenChanged();
}

void CostPage::read(const std::optional<CostCell>& cell) {
    if (!outcome_) return;
    const ParameterSearchResult& result = outcome_->result;
    if (!cell) {
        reading_->setText(tr("Point at a place to read it. Dark is good: few metres of cost."));
        return;
    }
    const GridPoint point{cell->cutoff, cell->threshold, leastIndex()};
    const SearchCost& cost = result.at(point);
    reading_->setText(tr("Cutoff %1, threshold %2: cost %3 m, distance %4 m, %5 unassociated of %6 candidates a trial")
                          .arg(centimetres(result.cutoffs_m[point.cutoff]),
                               discrepancyText(result.thresholds[point.threshold], result.settings.metric),
                               QLocale().toString(cost.cost, 'f', 3), QLocale().toString(cost.distance_m, 'f', 3),
                               QLocale().toString(cost.unassociatedCandidates, 'f', 1),
                               QLocale().toString(cost.candidates, 'f', 1)));
}

}  // namespace fodscope
