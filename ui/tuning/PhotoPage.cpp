// SPDX-License-Identifier: MIT
#include "ui/tuning/PhotoPage.h"

#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

#include "ui/panels/Format.h"
#include "ui/panels/PanelParts.h"
#include "ui/tuning/RecallPlot.h"
#include "ui/tuning/TuningValues.h"

namespace fodscope {
namespace {

QString perFod(const PhotoSearchResult& result, const PhotoOutcome& outcome) {
    return QLocale().toString(static_cast<double>(outcome.photos) / static_cast<double>(result.fodCount), 'f', 2);
}

QString precisionText(const PhotoOutcome& outcome) {
    return outcome.precision() ? percent(*outcome.precision()) : QStringLiteral("–");
}

QStringList outcomeTexts(const PhotoSearchResult& result, const std::optional<PhotoOutcome>& outcome) {
    if (!outcome) return {};
    return {percent(result.recallOf(*outcome)), precisionText(*outcome),    count(outcome->photos),
            perFod(result, *outcome),           count(outcome->candidates), count(outcome->candidatesWithoutPhoto)};
}

/// The point with the wanted recall.
std::optional<std::size_t> bestOf(const PhotoSearchResult& result) {
    for (std::size_t i = 0; i < result.curve.size(); ++i)
        if (result.best && result.curve[i].point == result.best->point) return i;
    return std::nullopt;
}

}  // namespace

PhotoPage::PhotoPage(QWidget* parent) : TuningPage(parent) {
    values_ = new TuningValues({
        {tr("Recall"), tr("Share of the FOD of all trials that at least one photo shows: 200 pixels of 1280 × 720")},
        {tr("Precision"), tr("Share of the photos that show FOD")},
        {tr("Photos"), tr("Over all trials")},
        {tr("Photos per FOD"), tr("Photos over all trials, divided by all FOD in them")},
        {tr("Candidates"), tr("Over all trials")},
        {tr("Without photo"), tr("Candidates that no photo shows: unreachable, hidden, too high …")},
    });
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    plot_ = new RecallPlot(this);
    plot_->setObjectName(QStringLiteral("tuning.plot"));
    reading_ = makeText({}, TextRole::Body, this);
    reading_->setObjectName(QStringLiteral("tuning.photoReading"));
    column->addWidget(plot_, 1);
    column->addWidget(reading_);
    connect(plot_, &RecallPlot::pointHovered, this, &PhotoPage::read);
    connect(plot_, &RecallPlot::pointChosen, this, &PhotoPage::choose);
}

void PhotoPage::showOutcome(const PhotoTuningOutcome& outcome) {
    outcome_ = outcome;
    chosen_.reset();
    best_ = bestOf(outcome_->result);
    plot_->setPoints(recallPointsOf(outcome_->result));
    plot_->setBest(best_);
    plot_->setChosen(std::nullopt);
    markInEffect(outcome_->inEffect);
    read(std::nullopt);
    if (!outcome_->result.curve.empty()) choose(best_.value_or(outcome_->result.curve.size() - 1));
}

std::optional<CandidateSettings> PhotoPage::chosen() const {
    if (!outcome_ || !chosen_) return std::nullopt;
    return outcome_->result.settingsAt(outcome_->result.curve[*chosen_].point);
}

void PhotoPage::chooseBest() {
    if (best_) choose(*best_);
}

void PhotoPage::markInEffect(const CandidateSettings& settings) {
    if (!outcome_) return;
    const std::optional<PhotoOutcome> known = knownOutcome(*outcome_, settings);
    values_->setInEffect(settings, outcomeTexts(outcome_->result, known));
    plot_->setInEffect(known ? recallPointOf(outcome_->result, *known) : std::nullopt);
}

void PhotoPage::choose(std::size_t point) {
    const PhotoSearchResult& result = outcome_->result;
    const PhotoChoice& choice = result.curve[point];
    chosen_ = point;
    plot_->setChosen(point);
    values_->setChosen(chosen_ == best_ ? tr("best") : tr("chosen"), result.settingsAt(choice.point),
                       outcomeTexts(result, choice.outcome));
    emit chosenChanged();
}

void PhotoPage::read(const std::optional<std::size_t>& point) {
    const PhotoSearchResult& result = outcome_->result;
    if (!point) {
        reading_->setText(
            tr("Each point of the curve has the fewest photos at its recall. Farther right more FOD are "
               "shown, with more photos that show none."));
        return;
    }
    const PhotoChoice& choice = result.curve[*point];
    const CandidateSettings settings = result.settingsAt(choice.point);
    reading_->setText(tr("%1 of %2 FOD on %3, precision %4: threshold %5, cutoff %6, least points %7")
                          .arg(count(choice.outcome.fodsShown), count(result.fodCount),
                               counted(choice.outcome.photos, tr("photo"), tr("photos")), precisionText(choice.outcome),
                               discrepancyText(settings.threshold, settings.metric),
                               centimetres(settings.clusterCutoff_m), QString::number(settings.minimumPoints)));
}

}  // namespace fodscope
