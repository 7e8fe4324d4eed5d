// SPDX-License-Identifier: MIT
#include "ui/commands/CandidateCommands.h"

namespace fodscope {
namespace {

QString idOf(Metric metric) {
    switch (metric) {
        case Metric::Euclidean:
            return QStringLiteral("metric.euclidean");
        case Metric::Mahalanobis:
            return QStringLiteral("metric.mahalanobis");
        case Metric::ChiSquare:
            return QStringLiteral("metric.chi-square");
    }
    return {};
}

QString nameOf(Metric metric) {
    switch (metric) {
        case Metric::Euclidean:
            return QObject::tr("Euclidean");
        case Metric::Mahalanobis:
            return QObject::tr("Mahalanobis");
        case Metric::ChiSquare:
            return QObject::tr("Chi-square");
    }
    return {};
}

QString helpOf(Metric metric) {
    switch (metric) {
        case Metric::Euclidean:
            return QObject::tr("Distance to the nearest reference point, in millimetres");
        case Metric::Mahalanobis:
            return QObject::tr("Distance measured against how much the nominal maps vary there; unitless");
        case Metric::ChiSquare:
            return QObject::tr(
                "How unlike the rest of the map the distances around a voxel are, by a local chi-square test; "
                "unitless. Works well only for maps of even density");
    }
    return {};
}

}  // namespace

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
    : Command(context, idOf(metric), nameOf(metric)), metric_(metric) {
    setCheckable(true);
    setToolTip(helpOf(metric));
}

void UseMetricCommand::run() {
    if (controller().state().parameters.candidates.metric != metric_)
        controller().commitCandidates(usualCandidateSettings(metric_, controller().state().parameters));
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
    const Parameters& parameters = controller().state().parameters;
    controller().commitCandidates(usualCandidateSettings(parameters.candidates.metric, parameters));
}

bool PaperSettingsCommand::isAvailable() const {
    const Parameters& parameters = controller().state().parameters;
    return controller().isOpen() && !controller().candidatesAreFrozen() &&
           parameters.candidates != usualCandidateSettings(parameters.candidates.metric, parameters);
}

TuningCommand::TuningCommand(CommandContext& context)
    : Command(context, QStringLiteral("candidate.tune"), QObject::tr("Find parameters from trials…")) {
    setPicture(Icon::Histogram);
    setKeys({QKeySequence(QStringLiteral("Ctrl+Shift+F"))});
    setToolTip(QObject::tr("Tries thousands of settings on maps with known FOD and shows what each costs"));
}

void TuningCommand::run() {
    navigation().showTuning();
}

bool TuningCommand::isAvailable() const {
    return controller().isOpen() && controller().state().reference;
}

QString TuningCommand::obstacle() const {
    return QObject::tr("load a reference first");
}

}  // namespace fodscope
