// SPDX-License-Identifier: MIT
#include "ui/panels/CandidatesPanel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <cmath>

#include "ui/commands/CommandSet.h"
#include "ui/panels/Format.h"
#include "ui/session/ParameterUse.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/NumberReadout.h"
#include "ui/widgets/ThresholdHistogram.h"
#include "ui/widgets/ValueSlider.h"

namespace fodscope {
namespace {

ValueRange thresholdRange(Metric metric) {
    if (metric == Metric::Mahalanobis) return {0.0, 12.0, 0.05, 0.5, QString(), 1.0, 2};
    if (metric == Metric::ChiSquare) return {0.0, 50.0, 0.1, 1.0, QString(), 1.0, 2};
    return {0.0, 0.25, 0.001, 0.01, QStringLiteral("mm"), 1000.0, 1};
}

/// χ² distances go to 3162, far beyond the thresholds of use: those beyond the slider are drawn just past its end.
std::vector<double> drawnValues(const DiscrepancyField& field, Metric metric) {
    std::vector<double> values = field.smoothed(metric);
    if (metric != Metric::ChiSquare) return values;
    const ValueRange range = thresholdRange(metric);
    for (double& value : values) {
        if (value > range.maximum) value = range.maximum + range.step;
    }
    return values;
}

constexpr double kCutoffMaximum_m = 1.0;
constexpr double kLeastPointsMaximum = 100.0;

}  // namespace

CandidatesPanel::CandidatesPanel(InspectionController& controller, const CommandSet& commands, QWidget* parent)
    : PanelColumn(parent), controller_(controller) {
    setObjectName(QStringLiteral("panel.candidates"));
    hint_ = makeText(tr("There is nothing to threshold yet: align a map with a reference first, in step 2."),
                     TextRole::Muted, this);
    addBare(hint_);
    body_ = new QWidget(this);
    auto* body = new QVBoxLayout(body_);
    body->setContentsMargins(0, 0, 0, 0);
    body->setSpacing(0);
    column()->addWidget(body_);

    auto* numbers = new QHBoxLayout;
    numbers->setContentsMargins(metrics::kPanelMargin_px, metrics::kPanelMargin_px, metrics::kPanelMargin_px, 0);
    candidates_ = new NumberReadout(tr("candidates"), this);
    candidates_->setObjectName(QStringLiteral("candidates.count"));
    above_ = new NumberReadout(tr("above threshold"), this);
    above_->setObjectName(QStringLiteral("candidates.above"));
    numbers->addWidget(candidates_, 1);
    numbers->addWidget(above_, 1);
    body->addLayout(numbers);

    auto* discrepancy = new Card(tr("Discrepancy"), this);
    auto* presetRow = new QHBoxLayout;
    presetRow->addWidget(new QLabel(tr("Preset"), discrepancy));
    preset_ = new QComboBox(discrepancy);
    preset_->setObjectName(QStringLiteral("candidates.preset"));
    for (const std::string& name : presetNames())
        preset_->addItem(QString::fromStdString(name), QString::fromStdString(name));
    preset_->addItem(tr("own values"), QString());
    preset_->setToolTip(
        tr("All settings of the detection at once, smoothing and clustering among them; can be undone"));
    presetRow->addWidget(preset_, 1);
    discrepancy->body()->addLayout(presetRow);
    auto* metricRow = new QHBoxLayout;
    metricRow->setSpacing(0);
    for (const char* id : {"metric.mahalanobis", "metric.euclidean", "metric.chi-square"})
        metricRow->addWidget(commands.makeButton(QString::fromLatin1(id), discrepancy), 1);
    discrepancy->body()->addLayout(metricRow);
    histogram_ = new ThresholdHistogram(discrepancy);
    histogram_->setObjectName(QStringLiteral("candidates.histogram"));
    discrepancy->body()->addWidget(histogram_);
    threshold_ = new ValueSlider(tr("Threshold"), thresholdRange(Metric::Mahalanobis), discrepancy);
    threshold_->setObjectName(QStringLiteral("slider.threshold"));
    threshold_->setHelp(
        tr("Voxels whose smoothed discrepancy is greater are discrepant. Keys [ and ], coarse with Shift."));
    discrepancy->body()->addWidget(threshold_);
    note_ = makeText({}, TextRole::Caption, discrepancy);
    note_->setObjectName(QStringLiteral("candidates.note"));
    discrepancy->body()->addWidget(note_);
    body->addWidget(discrepancy);

    auto* clusters = new Card(tr("Clusters"), this);
    cutoff_ = new ValueSlider(tr("Cluster cutoff"),
                              {0.02, kCutoffMaximum_m, 0.005, 0.05, QStringLiteral("cm"), 100.0, 1}, clusters);
    cutoff_->setObjectName(QStringLiteral("slider.cutoff"));
    cutoff_->setHelp(tr("Clusters that are at most this far apart are one candidate."));
    leastPoints_ =
        new ValueSlider(tr("Least points"), {0.0, kLeastPointsMaximum, 1.0, 10.0, tr("voxels"), 1.0, 0}, clusters);
    leastPoints_->setObjectName(QStringLiteral("slider.leastPoints"));
    leastPoints_->setHelp(tr("Candidates with fewer voxels are dropped."));
    linkage_ = new QComboBox(clusters);
    linkage_->setObjectName(QStringLiteral("candidates.linkage"));
    linkage_->addItem(tr("between centroids"), static_cast<int>(Linkage::Centroid));
    linkage_->addItem(tr("between nearest voxels"), static_cast<int>(Linkage::Single));
    linkage_->setToolTip(
        tr("From where to where the distance of two clusters is taken: centroid linkage keeps objects "
           "apart, single linkage joins chains of voxels"));
    centroid_ = new QComboBox(clusters);
    centroid_->setObjectName(QStringLiteral("candidates.centroid"));
    centroid_->setToolTip(tr("Where a candidate is said to be"));
    centroid_->addItem(tr("plain mean"), static_cast<int>(CentroidKind::Plain));
    centroid_->addItem(tr("weighted by discrepancy"), static_cast<int>(CentroidKind::DiscrepancyWeighted));
    auto* choices = new QFormLayout;
    choices->setHorizontalSpacing(12);
    choices->addRow(tr("Distance"), linkage_);
    choices->addRow(tr("Centroid"), centroid_);
    for (QComboBox* box : {preset_, linkage_, centroid_})
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    clusters->body()->addWidget(cutoff_);
    clusters->body()->addWidget(leastPoints_);
    clusters->body()->addLayout(choices);
    clusters->body()->addWidget(commands.makeButton(QStringLiteral("candidate.paper"), clusters));
    frozen_ = makeText(tr("Frozen: the visits have begun, so candidates keep their ids."), TextRole::Muted, clusters);
    clusters->body()->addWidget(frozen_);
    body->addWidget(clusters);
    auto* plan = commands.makeButton(QStringLiteral("visit.plan"), this, ButtonRole::Primary);
    auto* planRow = new QVBoxLayout;
    planRow->setContentsMargins(metrics::kPanelMargin_px, 0, metrics::kPanelMargin_px, 0);
    planRow->addWidget(plan);
    body->addLayout(planRow);
    column()->addStretch();

    for (ValueSlider* slider : {threshold_, cutoff_, leastPoints_}) {
        connect(slider, &ValueSlider::valueChanging, this, &CandidatesPanel::preview);
        connect(slider, &ValueSlider::valueCommitted, this, &CandidatesPanel::commit);
    }
    connect(histogram_, &ThresholdHistogram::thresholdDragged, this, [this](double value) {
        threshold_->setValue(value);
        preview();
    });
    connect(histogram_, &ThresholdHistogram::thresholdReleased, this, [this](double value) {
        threshold_->setValue(value);
        commit();
    });
    for (QComboBox* box : {linkage_, centroid_})
        connect(box, QOverload<int>::of(&QComboBox::activated), this, &CandidatesPanel::commit);
    connect(preset_, QOverload<int>::of(&QComboBox::activated), this, &CandidatesPanel::usePreset);
    connect(&controller, &InspectionController::sessionChanged, this, &CandidatesPanel::refreshField);
    connect(&controller, &InspectionController::detectionChanged, this, &CandidatesPanel::refreshField);
    connect(&controller, &InspectionController::parametersChanged, this, &CandidatesPanel::refreshField);
    connect(&controller, &InspectionController::candidatesChanged, this, &CandidatesPanel::refreshCounts);
    connect(&controller, &InspectionController::visitsChanged, this, &CandidatesPanel::refreshSettings);
    refreshField();
}

void CandidatesPanel::stepThreshold(int steps, bool coarse) {
    histogram_->stepThreshold(steps, coarse);
}

void CandidatesPanel::applyRanges(const Parameters& parameters) {
    const Metric metric = parameters.candidates.metric;
    const CandidateSettings usual = usualCandidateSettings(metric, parameters);
    if (rangedFor_ == usual) return;
    rangedFor_ = usual;
    const ValueRange range = thresholdRange(metric);
    threshold_->setRange(range);
    threshold_->setDefaultValue(usual.threshold);
    cutoff_->setDefaultValue(usual.clusterCutoff_m);
    leastPoints_->setDefaultValue(usual.minimumPoints);
    histogram_->setDisplay(range.unit, range.displayFactor, range.decimals);
    histogram_->setSteps(range.step, range.coarseStep);
}

void CandidatesPanel::refreshField() {
    const InspectionState& state = controller_.state();
    const bool hasField = state.detection && state.detection->field;
    hint_->setVisible(!hasField);
    body_->setVisible(hasField);
    const Metric metric = state.parameters.candidates.metric;
    applyRanges(state.parameters);
    const DiscrepancyField* field = hasField ? state.detection->field.get() : nullptr;
    if (field != binnedField_ || binnedMetric_ != metric) {
        binnedField_ = field;
        binnedMetric_ = metric;
        const bool isKnown = field != nullptr && field->has(metric);
        if (isKnown)
            histogram_->setValues(drawnValues(*field, metric));
        else
            histogram_->clear();
    }
    refreshSettings();
    refreshCounts();
}

void CandidatesPanel::refreshSettings() {
    const CandidateSettings& kept = controller_.state().parameters.candidates;
    if (!controller_.isPreviewing()) {
        threshold_->setValue(kept.threshold);
        histogram_->setThreshold(kept.threshold);
        cutoff_->setValue(kept.clusterCutoff_m);
        leastPoints_->setValue(kept.minimumPoints);
        linkage_->setCurrentIndex(linkage_->findData(static_cast<int>(kept.linkage)));
        centroid_->setCurrentIndex(centroid_->findData(static_cast<int>(kept.centroid)));
    }
    preset_->setCurrentIndex(
        preset_->findData(QString::fromStdString(detectionPresetOf(controller_.state().parameters))));
    const bool frozen = controller_.candidatesAreFrozen();
    frozen_->setVisible(frozen);
    for (QWidget* widget :
         {static_cast<QWidget*>(threshold_), static_cast<QWidget*>(cutoff_), static_cast<QWidget*>(leastPoints_),
          static_cast<QWidget*>(linkage_), static_cast<QWidget*>(centroid_), static_cast<QWidget*>(preset_),
          static_cast<QWidget*>(histogram_)})
        widget->setEnabled(!frozen);
}

void CandidatesPanel::refreshCounts() {
    const auto shown = controller_.shownCandidates();
    if (!shown) {
        candidates_->setUnknown();
        above_->setUnknown();
        note_->clear();
        return;
    }
    candidates_->setNumber(count(shown->candidates.size()));
    const std::size_t voxels = shown->candidateOfVoxel.size();
    const double share = voxels == 0 ? std::nan("") : static_cast<double>(shown->pointsAboveThreshold) / voxels;
    above_->setNumber(QString::number(share * 100.0, 'f', share < 0.01 ? 2 : 1), QStringLiteral("%"));
    QString note = tr("%1 of %2 voxels are discrepant.").arg(count(shown->pointsAboveThreshold), count(voxels));
    if (histogram_->countUnknown() > 0)
        note += tr(" %1 have no known value: the reference is untrained there.").arg(count(histogram_->countUnknown()));
    note_->setText(note);
}

CandidateSettings CandidatesPanel::settings() const {
    CandidateSettings settings = controller_.state().parameters.candidates;
    settings.threshold = threshold_->value();
    settings.clusterCutoff_m = cutoff_->value();
    settings.minimumPoints = static_cast<int>(std::lround(leastPoints_->value()));
    settings.linkage = static_cast<Linkage>(linkage_->currentData().toInt());
    settings.centroid = static_cast<CentroidKind>(centroid_->currentData().toInt());
    return settings;
}

void CandidatesPanel::usePreset() {
    const std::string name = preset_->currentData().toString().toStdString();
    if (!name.empty())
        controller_.applyParameters(
            withDetectionPreset(controller_.state().parameters, name,
                                controller_.state().reference && controller_.state().reference->hasCovariance()));
    refreshSettings();
}

void CandidatesPanel::preview() {
    histogram_->setThreshold(threshold_->value());
    controller_.previewCandidates(settings());
}

void CandidatesPanel::commit() {
    histogram_->setThreshold(threshold_->value());
    controller_.commitCandidates(settings());
}

}  // namespace fodscope
