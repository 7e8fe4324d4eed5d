// SPDX-License-Identifier: MIT
#include "ui/panels/MapPanel.h"

#include "ui/commands/CommandSet.h"
#include "ui/panels/Format.h"
#include "ui/panels/PoseList.h"
#include "ui/panels/ResidualCard.h"
#include "ui/panels/RouteCard.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/StatusChip.h"

namespace fodscope {
namespace {

/// The smallest thing that still has two points each way at this spacing.
QString spacingWarning(double spacing_m) {
    if (spacing_m < 0.02) return {};
    return QObject::tr("Objects under %1 may be missing: the map's spacing is %2.")
        .arg(centimetres(2.0 * spacing_m, 0), centimetres(spacing_m));
}

struct QualityWords {
    StatusKind kind = StatusKind::Neutral;
    QString chip;
    /// What can be done; empty when nothing has to be.
    QString remedy;
};

QualityWords qualityWords(RegistrationQuality quality) {
    switch (quality) {
        case RegistrationQuality::Given:
            return {StatusKind::Clear, QObject::tr("given"), {}};
        case RegistrationQuality::Good:
            return {StatusKind::Clear, QObject::tr("aligned"), {}};
        case RegistrationQuality::Ambiguous:
            return {StatusKind::Attention, QObject::tr("several poses fit"),
                    QObject::tr("No candidates are claimed until one of the poses is chosen.")};
        case RegistrationQuality::Bad:
            break;
    }
    return {StatusKind::Finding, QObject::tr("not aligned"),
            QObject::tr("No candidates are claimed from this alignment. Load the right reference or map, or give a "
                        "known start pose or transform.")};
}

}  // namespace

MapPanel::MapPanel(InspectionController& controller, const CommandSet& commands, QWidget* parent)
    : PanelColumn(parent), controller_(controller) {
    setObjectName(QStringLiteral("panel.map"));
    auto* map = new Card(tr("Map"), this);
    hint_ =
        makeText(tr("The map under inspection, as the robot made it: PCD or PLY, in metres."), TextRole::Muted, map);
    map->body()->addWidget(hint_);
    map->body()->addWidget(commands.makeButton(QStringLiteral("map.load"), map));
    fields_ = new FieldList(map);
    map->body()->addWidget(fields_);
    warning_ = makeText({}, TextRole::Body, map);
    warning_->setObjectName(QStringLiteral("map.warning"));
    map->body()->addWidget(warning_);
    column()->addWidget(map);

    alignment_ = new Card(tr("Alignment"), this);
    quality_ = new StatusChip(alignment_);
    alignment_->addHeaderWidget(quality_);
    sentence_ = makeText({}, TextRole::Emphasis, alignment_);
    sentence_->setObjectName(QStringLiteral("map.alignment"));
    remedy_ = makeText({}, TextRole::Body, alignment_);
    remedy_->setObjectName(QStringLiteral("map.remedy"));
    measures_ = new FieldList(alignment_);
    alignment_->body()->addWidget(sentence_);
    alignment_->body()->addWidget(remedy_);
    poses_ = new PoseList(controller, alignment_);
    alignment_->body()->addWidget(poses_);
    alignment_->body()->addWidget(measures_);
    auto* detect = commands.makeButton(QStringLiteral("map.detect"), alignment_, ButtonRole::Primary);
    alignment_->body()->addWidget(detect);
    for (const char* id : {"map.start", "map.transform", "map.register"})
        alignment_->body()->addWidget(commands.makeButton(QString::fromLatin1(id), alignment_));
    column()->addWidget(alignment_);
    column()->addWidget(new ResidualCard(controller, commands, this));
    column()->addWidget(new RouteCard(controller, commands, this));
    column()->addStretch();

    for (const auto signal : {&InspectionController::sessionChanged, &InspectionController::mapChanged,
                              &InspectionController::referenceChanged, &InspectionController::detectionChanged})
        connect(&controller, signal, this, &MapPanel::refresh);
    refresh();
}

void MapPanel::refresh() {
    refreshMap();
    refreshAlignment();
}

void MapPanel::refreshMap() {
    const InspectionState& state = controller_.state();
    std::vector<std::pair<QString, QString>> facts;
    QString warning;
    if (state.mapSource) {
        facts.emplace_back(tr("File"), fileNameOf(*state.mapSource));
        facts.emplace_back(tr("Points"), count(state.mapSource->points));
    }
    if (const auto& map = controller_.loadedMap()) {
        facts.emplace_back(tr("Dropped"),
                           map->cloud->droppedNonFinite == 0
                               ? tr("none")
                               : tr("%1 that were not numbers").arg(count(map->cloud->droppedNonFinite)));
        facts.emplace_back(tr("Spacing"), millimetres(map->spacing_m, 1));
        warning = spacingWarning(map->spacing_m);
    } else if (state.mapSource) {
        facts.emplace_back(tr("Spacing"), tr("not known until the file is read again"));
    }
    fields_->setFields(facts);
    hint_->setVisible(!state.mapSource);
    warning_->setText(warning);
    warning_->setVisible(!warning.isEmpty());
}

void MapPanel::refreshAlignment() {
    const InspectionState& state = controller_.state();
    if (!state.detection) {
        quality_->setStatus(StatusKind::ToDo, tr("not yet"));
        sentence_->setText(!state.reference   ? tr("Load a reference first: step 1.")
                           : !state.mapSource ? tr("Load the map first.")
                                              : tr("Not aligned yet."));
        remedy_->hide();
        poses_->setChoices({});
        measures_->setFields(std::vector<std::pair<QString, QString>>{});
        return;
    }
    const RegistrationResult& registration = state.detection->registration;
    const QualityWords words = qualityWords(registration.quality);
    quality_->setStatus(words.kind, words.chip);
    sentence_->setText(QString::fromStdString(registration.summary));
    remedy_->setVisible(!words.remedy.isEmpty());
    remedy_->setText(words.remedy);
    poses_->setChoices(poseChoices(registration));
    std::vector<std::pair<QString, QString>> measures;
    if (state.detection->coverage)
        measures.emplace_back(tr("Observed"),
                              tr("%1 of the reference").arg(observedText(state.detection->coverage->observedShare)));
    if (registration.uncertainty) {
        const PoseUncertainty& known = *registration.uncertainty;
        measures.emplace_back(tr("Position"),
                              deviationText(known.positionDeviation_m(), 1000.0, tr("mm (x, y, z)"), 1));
        measures.emplace_back(
            tr("Turn"), deviationText(known.angleDeviation_rad(), kDegreesPerRadian, tr("° (roll, pitch, yaw)"), 2));
        if (known.isLoose()) measures.emplace_back(tr("Not held"), QString::fromStdString(looseInWords(known)));
    }
    if (isTrusted(registration.quality) || registration.quality == RegistrationQuality::Ambiguous)
        measures.emplace_back(tr("Map origin at"), originText(poseFromTransform(registration.T_reference_from_map)));
    measures_->setFields(measures);
}

}  // namespace fodscope
