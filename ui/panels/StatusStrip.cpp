// SPDX-License-Identifier: MIT
#include "ui/panels/StatusStrip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "ui/commands/CommandSet.h"
#include "ui/panels/Format.h"
#include "ui/widgets/StatusChip.h"
#include "ui/widgets/TaskBar.h"

namespace fodscope {
namespace {

constexpr double kFreshFor_s = 2.0;
/// Tasks shorter than this would only flicker.
constexpr int kTaskShownAfter_ms = 150;

QString activityOf(const InspectionController& controller, const RobotState& robot) {
    for (const Visit& visit : controller.state().visits)
        if (isUnderWay(visit.state))
            return QObject::tr("%1 (%2)").arg(stateText(visit).word, QString::fromStdString(visit.waypointId));
    return robot.moving ? QObject::tr("moving") : QObject::tr("standing");
}

}  // namespace

StatusStrip::StatusStrip(InspectionController& controller, const CommandSet& commands, QWidget* parent)
    : QWidget(parent), controller_(controller) {
    setObjectName(QStringLiteral("statusStrip"));
    setSurface(this, SurfaceRole::Surface1);
    robot_ = new StatusChip(this);
    robot_->setObjectName(QStringLiteral("status.robot"));
    task_ = new TaskBar(this);
    task_->setObjectName(QStringLiteral("status.task"));
    counts_ = new QLabel(this);
    counts_->setObjectName(QStringLiteral("status.counts"));
    auto* stop = new QPushButton(icon(Icon::Stop, currentTheme().onFinding), tr("STOP"), this);
    stop->setObjectName(QStringLiteral("status.stop"));
    setButtonRole(stop, ButtonRole::Destructive);
    stop->setToolTip(tr("Cancels every goal of the robot at once (Ctrl+.). This is not a safety stop."));
    stop->setFocusPolicy(Qt::NoFocus);
    auto* notSafety = new QLabel(tr("not a safety stop"), this);
    setTextRole(notSafety, TextRole::Caption);

    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 4, 12, 4);
    row->setSpacing(16);
    row->addWidget(robot_);
    row->addWidget(task_, 1);
    row->addStretch();
    row->addWidget(counts_);
    auto* stopRow = new QHBoxLayout;
    stopRow->setSpacing(6);
    stopRow->addWidget(stop);
    stopRow->addWidget(notSafety);
    row->addLayout(stopRow);

    connect(stop, &QPushButton::clicked, commands.find(QStringLiteral("robot.stop")), &QAction::trigger);
    connect(task_, &TaskBar::cancelRequested, commands.find(QStringLiteral("task.cancel")), &QAction::trigger);
    taskDelay_.setSingleShot(true);
    taskDelay_.setInterval(kTaskShownAfter_ms);
    connect(&taskDelay_, &QTimer::timeout, this, [this] { task_->setTask(controller_.tasks().currentTask(), -1.0); });
    TaskRunner& tasks = controller.tasks();
    connect(&tasks, &TaskRunner::started, this, [this] { taskDelay_.start(); });
    connect(&tasks, &TaskRunner::progressed, this, [this](const TaskReport& report) {
        if (!taskDelay_.isActive()) task_->setTask(report.stage, report.fraction);
    });
    connect(&tasks, &TaskRunner::idle, this, [this] {
        taskDelay_.stop();
        task_->finish();
    });
    connect(&controller, &InspectionController::robotChanged, this, &StatusStrip::refreshRobot);
    for (const auto signal : {&InspectionController::sessionChanged, &InspectionController::candidatesChanged,
                              &InspectionController::photosChanged, &InspectionController::decisionsChanged,
                              &InspectionController::visitsChanged})
        connect(&controller, signal, this, &StatusStrip::refreshCounts);
    // The age of the pose grows while nothing is heard of the robot.
    ageTimer_.setInterval(500);
    connect(&ageTimer_, &QTimer::timeout, this, &StatusStrip::refreshRobot);
    ageTimer_.start();
    refreshRobot();
    refreshCounts();
}

void StatusStrip::refreshRobot() {
    const VisitDriver& visits = controller_.visits();
    const auto& state = visits.robotState();
    if (!visits.hasRobot() || !state) {
        robot_->setStatus(StatusKind::ToDo, visits.hasRobot() ? tr("robot: connecting") : tr("robot: none connected"));
        robot_->setDetail({});
        return;
    }
    if (state->link != LinkState::Connected) {
        robot_->setStatus(StatusKind::Finding, tr("robot: %1").arg(QString::fromStdString(toString(state->link))));
        robot_->setDetail({});
        return;
    }
    const double age_s = std::max(0.0, visits.now_s() - state->poseMeasured_s);
    const bool fresh = state->pose_map && age_s <= kFreshFor_s;
    robot_->setStatus(fresh ? StatusKind::Clear : StatusKind::Attention,
                      tr("robot: %1").arg(activityOf(controller_, *state)));
    robot_->setDetail(state->pose_map ? tr("pose %1 s old").arg(QString::number(age_s, 'f', 1)) : tr("pose not known"));
}

void StatusStrip::refreshCounts() {
    if (!controller_.isOpen()) {
        counts_->clear();
        return;
    }
    QStringList parts;
    if (const auto shown = controller_.shownCandidates())
        parts << counted(shown->candidates.size(), tr("candidate"), tr("candidates"));
    const auto& state = controller_.state();
    if (!state.photos.empty()) {
        parts << counted(state.photos.size(), tr("photo"), tr("photos"));
        parts << tr("%1 to label").arg(photosWithoutDecision(state).size());
    }
    counts_->setText(parts.join(QStringLiteral(" · ")));
}

}  // namespace fodscope
