// SPDX-License-Identifier: MIT
#include "ui/commands/CandidateCommands.h"

namespace fodscope {

NeighbourCandidateCommand::NeighbourCandidateCommand(CommandContext& context, int step)
    : Command(context, step > 0 ? QStringLiteral("candidate.next") : QStringLiteral("candidate.previous"),
              step > 0 ? QObject::tr("Next candidate") : QObject::tr("Previous candidate")),
      step_(step) {
    setPicture(step > 0 ? Icon::ChevronRight : Icon::ChevronLeft);
    setKeys({step > 0 ? QKeySequence(Qt::Key_Tab) : QKeySequence(QStringLiteral("Shift+Backtab"))});
}

void NeighbourCandidateCommand::run() {
    controller().selectNeighbour(step_);
}

bool NeighbourCandidateCommand::isAvailable() const {
    const auto shown = controller().shownCandidates();
    return shown && !shown->candidates.empty();
}

FlyToCandidateCommand::FlyToCandidateCommand(CommandContext& context)
    : Command(context, QStringLiteral("candidate.fly"), QObject::tr("Fly to the candidate")) {
    setPicture(Icon::Target);
    setKeys({QKeySequence(Qt::Key_F)});
}

void FlyToCandidateCommand::run() {
    controller().flyToCandidate(controller().selectedCandidate());
}

bool FlyToCandidateCommand::isAvailable() const {
    return !controller().selectedCandidate().isEmpty();
}

StepThresholdCommand::StepThresholdCommand(CommandContext& context, int step, bool coarse)
    : Command(context, QStringLiteral("threshold.%1%2").arg(step > 0 ? "up" : "down", coarse ? ".coarse" : ""),
              step > 0 ? (coarse ? QObject::tr("Threshold up, coarse") : QObject::tr("Threshold up"))
                       : (coarse ? QObject::tr("Threshold down, coarse") : QObject::tr("Threshold down"))),
      step_(step),
      coarse_(coarse) {
    setPicture(step > 0 ? Icon::Plus : Icon::Minus);
    if (!coarse)
        setKeys({QKeySequence(step > 0 ? Qt::Key_BracketRight : Qt::Key_BracketLeft)});
    else
        // Shift turns the brackets into braces on most keyboards.
        setKeys({QKeySequence(step > 0 ? QStringLiteral("Shift+]") : QStringLiteral("Shift+[")),
                 QKeySequence(step > 0 ? QStringLiteral("Shift+}") : QStringLiteral("Shift+{"))});
}

void StepThresholdCommand::run() {
    navigation().stepThreshold(step_, coarse_);
}

bool StepThresholdCommand::isAvailable() const {
    return controller().state().detection && controller().state().detection->field &&
           !controller().candidatesAreFrozen();
}

UseMetricCommand::UseMetricCommand(CommandContext& context, Metric metric)
    : Command(context,
              metric == Metric::Mahalanobis ? QStringLiteral("metric.mahalanobis") : QStringLiteral("metric.euclidean"),
              metric == Metric::Mahalanobis ? QObject::tr("Mahalanobis") : QObject::tr("Euclidean")),
      metric_(metric) {
    setCheckable(true);
    setToolTip(metric == Metric::Mahalanobis
                   ? QObject::tr("Distance measured against how much the nominal maps vary there; unitless")
                   : QObject::tr("Distance to the nearest reference point, in millimetres"));
}

void UseMetricCommand::run() {
    if (controller().state().parameters.candidates.metric != metric_)
        controller().commitCandidates(paperPhysicalCandidateSettings(metric_));
    refresh();
}

bool UseMetricCommand::isAvailable() const {
    return controller().isOpen() && !controller().candidatesAreFrozen();
}

void UseMetricCommand::refresh() {
    Command::refresh();
    setChecked(controller().state().parameters.candidates.metric == metric_);
}

PaperSettingsCommand::PaperSettingsCommand(CommandContext& context)
    : Command(context, QStringLiteral("candidate.paper"), QObject::tr("Back to the defaults")) {
    setPicture(Icon::Retry);
    setToolTip(QObject::tr("Threshold, cutoff and least points of the published physical trials, for this metric"));
}

void PaperSettingsCommand::run() {
    controller().commitCandidates(paperPhysicalCandidateSettings(controller().state().parameters.candidates.metric));
}

bool PaperSettingsCommand::isAvailable() const {
    const CandidateSettings& settings = controller().state().parameters.candidates;
    return controller().isOpen() && !controller().candidatesAreFrozen() &&
           !(settings == paperPhysicalCandidateSettings(settings.metric));
}

}  // namespace fodscope
