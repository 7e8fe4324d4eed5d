// SPDX-License-Identifier: MIT
#include "ui/panels/EvidencePanel.h"

#include <QPixmap>
#include <QPushButton>
#include <algorithm>

#include "ui/commands/CommandSet.h"
#include "ui/panels/Format.h"
#include "ui/theme/Colours.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/EmptyState.h"
#include "ui/widgets/StatusChip.h"

namespace fodscope {
namespace {

constexpr int kLeastWidth_px = 264;
constexpr int kThumbnailWidth_px = 216;
constexpr std::size_t kMostThumbnails = 4;

QPixmap thumbnail(const Photo& photo) {
    QPixmap picture;
    picture.loadFromData(reinterpret_cast<const uchar*>(photo.bytes.data()), static_cast<uint>(photo.bytes.size()));
    return picture.isNull() ? picture : picture.scaledToWidth(kThumbnailWidth_px, Qt::SmoothTransformation);
}

std::vector<std::pair<QString, QString>> measuresOf(const Candidate& candidate, Metric metric) {
    return {{QObject::tr("Size"), sizeText(candidate.size_m)},
            {QObject::tr("Above floor"), centimetres(candidate.heightAboveFloor_m)},
            {QObject::tr("Points"), QObject::tr("%1 voxels").arg(count(candidate.voxels.size()))},
            {QObject::tr("Greatest"), discrepancyText(candidate.discrepancyMax, metric)},
            {QObject::tr("Mean"), discrepancyText(candidate.discrepancyMean, metric)},
            {QObject::tr("In reference"), placeText(candidate.centroid_reference)},
            {QObject::tr("In map"), placeText(candidate.centroid_map)}};
}

std::vector<std::pair<QString, QString>> visitOfCandidate(const InspectionState& state, const std::string& id) {
    const Waypoint* waypoint = waypointOf(state, id);
    if (waypoint == nullptr) return {};
    std::vector<std::pair<QString, QString>> fields{{QObject::tr("Waypoint"), QString::fromStdString(waypoint->id)}};
    if (!waypoint->pose_map) {
        fields.emplace_back(QObject::tr("No pose"), QString::fromStdString(toString(waypoint->status)));
        return fields;
    }
    if (const Visit* visit = visitOf(state, waypoint->id)) {
        fields.emplace_back(QObject::tr("Visit"), stateText(*visit).word);
        if (const std::string why = reasonText(*visit); !why.empty())
            fields.emplace_back(QObject::tr("Why"), QString::fromStdString(why));
    }
    return fields;
}

}  // namespace

EvidencePanel::EvidencePanel(InspectionController& controller, const CommandSet& commands, QWidget* parent)
    : PanelColumn(parent, kLeastWidth_px), controller_(controller) {
    setObjectName(QStringLiteral("panel.evidence"));
    empty_ = new EmptyState(this);
    empty_->showEmpty(Icon::Target,
                      tr("Select a candidate in the view, the plan or the table to see what is known of it."));
    addBare(empty_);

    card_ = new Card(tr("Candidate"), this);
    card_->setObjectName(QStringLiteral("evidence.candidate"));
    chip_ = new StatusChip(card_);
    swatch_ = new QLabel(card_);
    auto* state = new QHBoxLayout;
    state->addWidget(swatch_);
    state->addWidget(chip_, 1);
    card_->body()->addLayout(state);
    measures_ = new FieldList(card_);
    measures_->setObjectName(QStringLiteral("evidence.measures"));
    card_->body()->addWidget(measures_);
    visit_ = new FieldList(card_);
    card_->body()->addWidget(visit_);
    auto* buttons = new QHBoxLayout;
    for (const char* id : {"candidate.previous", "candidate.next"}) {
        auto* button = commands.makeButton(QString::fromLatin1(id), card_);
        button->setAccessibleName(commands.find(QString::fromLatin1(id))->text());
        buttons->addWidget(button);
        // Beside each other only their pictures fit.
        connect(commands.find(QString::fromLatin1(id)), &QAction::changed, button, [button] { button->setText({}); });
        button->setText({});
    }
    auto* fly = commands.makeButton(QStringLiteral("candidate.fly"), card_);
    connect(commands.find(QStringLiteral("candidate.fly")), &QAction::changed, fly,
            [fly] { fly->setText(tr("Fly to")); });
    fly->setText(tr("Fly to"));
    buttons->addWidget(fly, 1);
    card_->body()->addLayout(buttons);
    column()->addWidget(card_);

    photosCard_ = new Card(tr("Photos"), this);
    photos_ = new QVBoxLayout;
    photosCard_->body()->addLayout(photos_);
    column()->addWidget(photosCard_);

    probeCard_ = new Card(tr("Picked point"), this);
    probe_ = new FieldList(probeCard_);
    probe_->setObjectName(QStringLiteral("evidence.probe"));
    probeCard_->body()->addWidget(probe_);
    column()->addWidget(probeCard_);
    column()->addStretch();

    for (const auto signal : {&InspectionController::sessionChanged, &InspectionController::candidatesChanged,
                              &InspectionController::planChanged, &InspectionController::visitsChanged,
                              &InspectionController::photosChanged, &InspectionController::decisionsChanged})
        connect(&controller, signal, this, &EvidencePanel::refresh);
    connect(&controller, &InspectionController::selectionChanged, this, &EvidencePanel::refresh);
    connect(&controller, &InspectionController::probeChanged, this, &EvidencePanel::refresh);
    refresh();
}

void EvidencePanel::refresh() {
    refreshCandidate();
    refreshProbe();
    empty_->setVisible(card_->isHidden() && probeCard_->isHidden());
}

void EvidencePanel::refreshCandidate() {
    const QString id = controller_.selectedCandidate();
    const Candidate* candidate = controller_.findShownCandidate(id);
    card_->setVisible(candidate != nullptr);
    photosCard_->setVisible(false);
    if (candidate == nullptr) return;
    const InspectionState& state = controller_.state();
    card_->setTitle(id);
    QPixmap colour(12, 12);
    colour.fill(candidateColour(id));
    swatch_->setPixmap(colour);
    StateText text{StatusKind::Attention, tr("preview")};
    for (const CandidateVerdict& verdict : controller_.verdicts())
        if (verdict.candidateId == candidate->id) text = candidateState(state, verdict);
    chip_->setStatus(text.kind, text.word);
    measures_->setFields(measuresOf(*candidate, controller_.shownCandidateSettings().metric));
    const auto visit = visitOfCandidate(state, candidate->id);
    visit_->setVisible(!visit.empty());
    visit_->setFields(visit);
    showPhotos(candidate->id);
}

void EvidencePanel::showPhotos(const std::string& candidateId) {
    std::vector<std::string> ids;
    for (const Photo& photo : controller_.state().photos)
        if (std::ranges::find(photo.candidateIds, candidateId) != photo.candidateIds.end()) ids.push_back(photo.id);
    photosCard_->setVisible(!ids.empty());
    if (ids == shownPhotos_) return;
    shownPhotos_ = ids;
    while (QLayoutItem* item = photos_->takeAt(0)) {
        if (item->widget()) item->widget()->deleteLater();
        delete item;
    }
    for (std::size_t i = 0; i < std::min(ids.size(), kMostThumbnails); ++i) {
        const QString id = QString::fromStdString(ids[i]);
        const QPixmap picture = thumbnail(*controller_.findPhoto(id));
        auto* button = new QPushButton(photosCard_);
        setButtonRole(button, ButtonRole::Quiet);
        button->setObjectName(QStringLiteral("evidence.photo"));
        button->setToolTip(tr("%1: open it to label").arg(id));
        button->setIcon(picture);
        button->setIconSize(picture.size());
        button->setFixedHeight(picture.height() + 8);
        connect(button, &QPushButton::clicked, this, [this, id] { controller_.selectPhoto(id); });
        photos_->addWidget(button);
    }
}

void EvidencePanel::refreshProbe() {
    probeCard_->setVisible(!controller_.probe().empty());
    probe_->setFields(controller_.probe());
}

}  // namespace fodscope
