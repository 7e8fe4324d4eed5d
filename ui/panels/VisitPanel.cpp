// SPDX-License-Identifier: MIT
#include "ui/panels/VisitPanel.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QTreeWidget>
#include <algorithm>

#include "ui/commands/CommandSet.h"
#include "ui/panels/Format.h"
#include "ui/plan/CameraPreview.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/StatusChip.h"

namespace fodscope {
namespace {

QDoubleSpinBox* poseBox(const QString& suffix, double limit, QWidget* parent) {
    auto* box = new QDoubleSpinBox(parent);
    box->setRange(-limit, limit);
    box->setDecimals(2);
    box->setSuffix(suffix);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    return box;
}

QString poseText(const Pose2& pose) {
    return QObject::tr("%1, %2 m, %3°")
        .arg(QString::number(pose.x_m, 'f', 2), QString::number(pose.y_m, 'f', 2),
             QString::number(degreesFromRadians(pose.yaw_rad), 'f', 0));
}

StateText runnerText(RunnerState state, const std::vector<Visit>& visits) {
    switch (state) {
        case RunnerState::Idle:
            if (const auto over = std::ranges::count_if(visits, isOver, &Visit::state); over > 0) {
                const bool all = over == static_cast<std::ptrdiff_t>(visits.size());
                return all ? StateText{StatusKind::Clear, QObject::tr("finished")}
                           : StateText{StatusKind::Attention, QObject::tr("interrupted")};
            }
            return {StatusKind::ToDo, QObject::tr("not started")};
        case RunnerState::Running:
            return {StatusKind::Running, QObject::tr("driving")};
        case RunnerState::Paused:
            if (std::ranges::any_of(visits, isUnderWay, &Visit::state))
                return {StatusKind::Running, QObject::tr("pauses after this visit")};
            return {StatusKind::Attention, QObject::tr("paused")};
        case RunnerState::Finished:
            return {StatusKind::Clear, QObject::tr("finished")};
    }
    return {};
}

/// "driving, 2nd try": a first try goes without saying.
QString withTries(const QString& word, const Visit& visit) {
    if (visit.state == VisitState::Photo && visit.photoTries > 1)
        return QObject::tr("%1, try %2").arg(word).arg(visit.photoTries);
    if (visit.tries < 2 || visit.state == VisitState::Draft) return word;
    return isUnderWay(visit.state) ? QObject::tr("%1, try %2").arg(word).arg(visit.tries)
                                   : QObject::tr("%1, %2 tries").arg(word).arg(visit.tries);
}

/// The line under the list: what became of the visit, why, and how often it was tried.
QString storyOf(const Visit& visit) {
    QStringList parts{QString::fromStdString(visit.waypointId), stateText(visit).word};
    if (const std::string why = reasonText(visit); !why.empty()) parts << QString::fromStdString(why);
    if (visit.tries > 0)
        parts << counted(static_cast<std::size_t>(visit.tries), QObject::tr("drive"), QObject::tr("drives"));
    if (visit.photoTries > 0)
        parts << counted(static_cast<std::size_t>(visit.photoTries), QObject::tr("photo asked for"),
                         QObject::tr("photos asked for"));
    return parts.join(QStringLiteral(" · "));
}

/// The one that needs words most: under way, else the last that failed or waits with a reason.
const Visit* visitToTell(const std::vector<Visit>& visits) {
    const Visit* told = nullptr;
    for (const Visit& visit : visits) {
        if (isUnderWay(visit.state)) return &visit;
        if (visit.reason != VisitReason::None && visit.reason != VisitReason::NoPose) told = &visit;
    }
    return told;
}

QString metres(double length_m) {
    return QObject::tr("%1 m").arg(QString::number(length_m, 'f', 1));
}

/// The length of the route, and what the other order would make of it.
QString routeText(const VisitPlan& plan) {
    if (!plan.nearestNextLength_m || !plan.shortestTourLength_m) return metres(plan.length_m);
    return QObject::tr("%1 (nearest next %2, shortest tour %3)")
        .arg(metres(plan.length_m), metres(*plan.nearestNextLength_m), metres(*plan.shortestTourLength_m));
}

QString joined(const std::vector<std::string>& ids) {
    QStringList words;
    for (const std::string& id : ids)
        words << QString::fromStdString(id);
    return words.join(QStringLiteral(", "));
}

}  // namespace

VisitPanel::VisitPanel(InspectionController& controller, const CommandSet& commands, QWidget* parent)
    : PanelColumn(parent), controller_(controller) {
    setObjectName(QStringLiteral("panel.visit"));
    makeRobotCard(commands);
    makePlanCard(commands);
    makeDriveCard(commands);
    makePreviewCard();
    column()->addStretch();
    connect(&controller, &InspectionController::sessionChanged, this, &VisitPanel::refresh);
    connect(&controller, &InspectionController::robotChanged, this, &VisitPanel::refreshRobot);
    connect(&controller, &InspectionController::planChanged, this, &VisitPanel::refresh);
    connect(&controller, &InspectionController::detectionChanged, this, &VisitPanel::refresh);
    connect(&controller, &InspectionController::visitsChanged, this, &VisitPanel::refreshVisits);
    connect(&controller, &InspectionController::photosChanged, this, &VisitPanel::refreshVisits);
    connect(&controller, &InspectionController::selectionChanged, this, &VisitPanel::selectRow);
    connect(&controller, &InspectionController::waypointSelectionChanged, this, &VisitPanel::selectRow);
    // The age of the pose grows while nothing is heard of the robot.
    ageTimer_.setInterval(500);
    connect(&ageTimer_, &QTimer::timeout, this, &VisitPanel::refreshRobot);
    ageTimer_.start();
    refresh();
}

void VisitPanel::makeRobotCard(const CommandSet& commands) {
    robot_ = new Card(tr("Robot"), this);
    link_ = new StatusChip(robot_);
    robot_->addHeaderWidget(link_);
    robotFields_ = new FieldList(robot_);
    robot_->body()->addWidget(robotFields_);
    for (const char* id : {"robot.builtin", "robot.world"}) {
        connectButtons_.push_back(commands.makeButton(QString::fromLatin1(id), robot_));
        robot_->body()->addWidget(connectButtons_.back());
    }
    start_ = new QWidget(robot_);
    auto* grid = new QGridLayout(start_);
    grid->setContentsMargins(0, 0, 0, 0);
    auto* label = makeText(tr("Start of the route, map frame"), TextRole::Muted, start_);
    startX_ = poseBox(tr(" m"), 1000.0, start_);
    startY_ = poseBox(tr(" m"), 1000.0, start_);
    startYaw_ = poseBox(tr("°"), 360.0, start_);
    startX_->setObjectName(QStringLiteral("visit.startX"));
    startY_->setObjectName(QStringLiteral("visit.startY"));
    startYaw_->setObjectName(QStringLiteral("visit.startYaw"));
    grid->addWidget(label, 0, 0, 1, 3);
    grid->addWidget(startX_, 1, 0);
    grid->addWidget(startY_, 1, 1);
    grid->addWidget(startYaw_, 1, 2);
    robot_->body()->addWidget(start_);
    for (QDoubleSpinBox* box : {startX_, startY_, startYaw_})
        connect(box, &QDoubleSpinBox::editingFinished, this, &VisitPanel::takeStart);
    column()->addWidget(robot_);
}

void VisitPanel::makePlanCard(const CommandSet& commands) {
    auto* plan = new Card(tr("Plan"), this);
    planHint_ = makeText({}, TextRole::Muted, plan);
    planHint_->setObjectName(QStringLiteral("visit.planHint"));
    planFields_ = new FieldList(plan);
    plan->body()->addWidget(planHint_);
    plan->body()->addWidget(planFields_);
    auto* button = commands.makeButton(QStringLiteral("visit.plan"), plan, ButtonRole::Primary);
    plan->body()->addWidget(button);
    plan->body()->addWidget(commands.makeButton(QStringLiteral("visit.grid"), plan));
    column()->addWidget(plan);
}

void VisitPanel::makeDriveCard(const CommandSet& commands) {
    drive_ = new Card(tr("Drive"), this);
    runner_ = new StatusChip(drive_);
    drive_->addHeaderWidget(runner_);
    told_ = makeText({}, TextRole::Body, drive_);
    told_->setObjectName(QStringLiteral("visit.told"));
    drive_->body()->addWidget(told_);
    progress_ = new QProgressBar(drive_);
    progress_->setTextVisible(false);
    progress_->setObjectName(QStringLiteral("visit.progress"));
    drive_->body()->addWidget(progress_);
    auto* buttons = new QGridLayout;
    auto* start = commands.makeButton(QStringLiteral("visit.start"), drive_, ButtonRole::Primary);
    buttons->addWidget(start, 0, 0, 1, 2);
    buttons->addWidget(commands.makeButton(QStringLiteral("visit.pause"), drive_), 1, 0, 1, 2);
    buttons->addWidget(commands.makeButton(QStringLiteral("visit.skip"), drive_), 2, 0);
    buttons->addWidget(commands.makeButton(QStringLiteral("visit.retry"), drive_), 2, 1);
    drive_->body()->addLayout(buttons);
    list_ = new QTreeWidget(drive_);
    list_->setObjectName(QStringLiteral("visit.list"));
    // Without headings: the words say what they are, and the panel is narrow.
    list_->setHeaderLabels({QString(), QString(), QString()});
    list_->setHeaderHidden(true);
    list_->header()->setMinimumSectionSize(24);
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setMinimumHeight(140);
    list_->setFrameShape(QFrame::NoFrame);
    list_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    drive_->body()->addWidget(list_);
    story_ = makeText({}, TextRole::Muted, drive_);
    story_->setObjectName(QStringLiteral("visit.story"));
    drive_->body()->addWidget(story_);
    auto* changes = new QHBoxLayout;
    for (const char* id : {"visit.earlier", "visit.later", "visit.remove"})
        changes->addWidget(commands.makeButton(QString::fromLatin1(id), drive_));
    drive_->body()->addLayout(changes);
    column()->addWidget(drive_);
    connect(list_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (item == nullptr || filling_) return;
        const QString candidate = item->data(0, Qt::UserRole).toString();
        controller_.selectWaypoint(item->text(0));
        if (!item->text(1).split(QStringLiteral(", ")).contains(controller_.selectedCandidate()))
            controller_.selectCandidate(candidate);
    });
}

void VisitPanel::makePreviewCard() {
    preview_ = new Card(tr("What the camera will see"), this);
    preview_->setCaption(tr("From the map: voxels, the candidates in their colours"));
    picture_ = new QLabel(preview_);
    picture_->setObjectName(QStringLiteral("visit.preview"));
    preview_->body()->addWidget(picture_);
    column()->addWidget(preview_);
}

void VisitPanel::refreshPreview() {
    const InspectionState& state = controller_.state();
    const std::string id = controller_.selectedWaypoint().toStdString();
    const Waypoint* chosen = nullptr;
    if (state.plan && state.detection) {
        const auto found = std::ranges::find(state.plan->waypoints, id, &Waypoint::id);
        if (found != state.plan->waypoints.end() && found->pose_map) chosen = &*found;
    }
    preview_->setVisible(chosen != nullptr);
    if (chosen == nullptr) return;
    // Visits change many times a minute, the picture only with pose, candidates and theme.
    const auto key = std::tuple(chosen->pose_map->x_m, chosen->pose_map->y_m, chosen->pose_map->yaw_rad,
                                static_cast<const void*>(state.detection->candidates.get()), currentTheme().kind);
    if (key == previewed_) return;
    previewed_ = key;
    constexpr int kWidth_px = 256;
    const double ratio = devicePixelRatioF();
    QImage image = cameraPreview(*state.detection, state.parameters.camera, *chosen->pose_map,
                                 static_cast<int>(kWidth_px * ratio), currentTheme());
    image.setDevicePixelRatio(ratio);
    picture_->setPixmap(QPixmap::fromImage(image));
    preview_->setTitle(tr("What the camera will see at %1").arg(QString::fromStdString(id)));
}

void VisitPanel::refresh() {
    refreshRobot();
    refreshPlan();
    refreshVisits();
}

void VisitPanel::refreshRobot() {
    const VisitDriver& visits = controller_.visits();
    const auto& state = visits.robotState();
    start_->setVisible(!visits.hasRobot());
    for (QWidget* button : connectButtons_)
        button->setVisible(!visits.hasRobot() && (button->objectName() != QStringLiteral("button.robot.builtin") ||
                                                  controller_.isOnBuiltinTank()));
    if (!visits.hasRobot()) {
        link_->setStatus(StatusKind::ToDo, tr("none"));
        robotFields_->setFields({{tr("Now"), tr("Connect a robot to drive the plan; a plan can be made without.")}});
        if (const auto start = controller_.robotStart(); start && !startX_->hasFocus() && !startY_->hasFocus()) {
            startX_->setValue(start->x_m);
            startY_->setValue(start->y_m);
            startYaw_->setValue(degreesFromRadians(start->yaw_rad));
        }
        return;
    }
    const bool connected = state && state->link == LinkState::Connected;
    link_->setStatus(connected ? StatusKind::Clear : StatusKind::Attention,
                     state ? QString::fromStdString(toString(state->link)) : tr("connecting"));
    std::vector<std::pair<QString, QString>> fields{{tr("Robot"), visits.robotName()}};
    if (state && state->pose_map) {
        const double age_s = std::max(0.0, visits.now_s() - state->poseMeasured_s);
        fields.emplace_back(tr("Position"), poseText(*state->pose_map));
        fields.emplace_back(tr("Measured"), tr("%1 s ago").arg(QString::number(age_s, 'f', 1)));
    } else {
        fields.emplace_back(tr("Position"), tr("not known"));
    }
    robotFields_->setFields(fields);
}

void VisitPanel::refreshPlan() {
    const InspectionState& state = controller_.state();
    planHint_->setVisible(!state.plan);
    planFields_->setVisible(state.plan.has_value());
    const bool hasCandidates = state.detection && state.detection->candidates;
    if (!state.plan) {
        planHint_->setText(!hasCandidates ? tr("There are no candidates to visit yet: find them in step 3.")
                           : state.detection->candidates->candidates.empty()
                               ? tr("No candidate is above the threshold, so there is nothing to visit.")
                               : tr("Poses to photograph the candidates from, as few as possible."));
        return;
    }
    const auto reachable =
        std::ranges::count_if(state.plan->waypoints, [](const Waypoint& w) { return w.pose_map.has_value(); });
    planFields_->setFields(
        {{tr("Waypoints"), QString::number(reachable)},
         {tr("Without one"), QString::number(static_cast<int>(state.plan->waypoints.size()) - reachable)},
         {tr("Route"), routeText(*state.plan)}});
}

void VisitPanel::refreshVisits() {
    const InspectionState& state = controller_.state();
    drive_->setVisible(state.plan.has_value());
    if (!state.plan) {
        list_->clear();
        return;
    }
    const StateText running = runnerText(controller_.visits().runnerState(), state.visits);
    runner_->setStatus(running.kind, running.word);
    const auto over = std::ranges::count_if(state.visits, isOver, &Visit::state);
    progress_->setRange(0, std::max<int>(1, static_cast<int>(state.visits.size())));
    progress_->setValue(static_cast<int>(over));
    told_->setText(tr("%1 of %2 visits over, %3")
                       .arg(over)
                       .arg(state.visits.size())
                       .arg(counted(state.photos.size(), tr("photo"), tr("photos"))));
    filling_ = true;
    const auto rows = static_cast<int>(state.plan->waypoints.size());
    while (list_->topLevelItemCount() > rows)
        delete list_->takeTopLevelItem(list_->topLevelItemCount() - 1);
    while (list_->topLevelItemCount() < rows)
        list_->addTopLevelItem(new QTreeWidgetItem);
    const Theme theme = currentTheme();
    for (int i = 0; i < rows; ++i) {
        const Waypoint& waypoint = state.plan->waypoints[static_cast<std::size_t>(i)];
        const Visit* visit = visitOf(state, waypoint.id);
        const StateText text =
            !waypoint.pose_map ? StateText{StatusKind::NotObserved, QString::fromStdString(toString(waypoint.status))}
            : visit            ? stateText(*visit)
                               : StateText{StatusKind::ToDo, tr("to be visited")};
        QTreeWidgetItem* item = list_->topLevelItem(i);
        item->setText(0, QString::fromStdString(waypoint.id));
        item->setText(1, joined(waypoint.candidateIds));
        item->setText(2, visit ? withTries(text.word, *visit) : text.word);
        item->setForeground(2, statusColour(theme, text.kind));
        item->setToolTip(2, visit ? QString::fromStdString(reasonText(*visit)) : QString());
        item->setData(
            0, Qt::UserRole,
            waypoint.candidateIds.empty() ? QString() : QString::fromStdString(waypoint.candidateIds.front()));
    }
    filling_ = false;
    selectRow();
}

void VisitPanel::tellStory() {
    const InspectionState& state = controller_.state();
    const Waypoint* waypoint = waypointOf(state, controller_.selectedCandidate().toStdString());
    const Visit* visit = waypoint ? visitOf(state, waypoint->id) : nullptr;
    if (visit == nullptr || (visit->reason == VisitReason::None && !isUnderWay(visit->state) && visit->tries == 0))
        visit = visitToTell(state.visits);
    story_->setVisible(visit != nullptr);
    if (visit != nullptr) story_->setText(storyOf(*visit));
}

void VisitPanel::selectRow() {
    tellStory();
    filling_ = true;
    QTreeWidgetItem* chosen = nullptr;
    const auto isOf = [&](const QTreeWidgetItem* item) {
        return item->text(1).split(QStringLiteral(", ")).contains(controller_.selectedCandidate());
    };
    for (int i = list_->topLevelItemCount(); i-- > 0;)
        if (isOf(list_->topLevelItem(i))) chosen = list_->topLevelItem(i);
    // A waypoint that was chosen goes before another one of the same candidate.
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* item = list_->topLevelItem(i);
        const bool isFree = controller_.selectedCandidate().isEmpty() || isOf(item) || item->text(1).isEmpty();
        if (item->text(0) == controller_.selectedWaypoint() && isFree) chosen = item;
    }
    list_->setCurrentItem(chosen);
    filling_ = false;
    if (chosen != nullptr) controller_.selectWaypoint(chosen->text(0));
    refreshPreview();
}

void VisitPanel::takeStart() {
    controller_.setRobotStart({startX_->value(), startY_->value(), radiansFromDegrees(startYaw_->value())});
}

}  // namespace fodscope
