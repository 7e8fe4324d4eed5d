// SPDX-License-Identifier: MIT
#include "ui/commands/CommandSet.h"

#include <QMenuBar>
#include <QPushButton>

#include "ui/commands/CandidateCommands.h"
#include "ui/commands/InputCommands.h"
#include "ui/commands/RouteCommands.h"
#include "ui/commands/SessionCommands.h"
#include "ui/commands/VisitCommands.h"
#include "ui/commands/WindowCommands.h"

namespace fodscope {
namespace {

struct MenuPlan {
    QString title;
    /// Ids; an empty one is a separator.
    QStringList ids;
};

std::vector<MenuPlan> menus() {
    return {{QObject::tr("&Inspection"),
             {"session.new", "session.builtin", "session.open", "", "session.close", "", "session.quit"}},
            {QObject::tr("&Edit"), {"edit.undo", "edit.redo", "", "settings.all", "", "task.cancel", "view.leave"}},
            {QObject::tr("&View"),
             {"step.1", "step.2", "step.3", "step.4", "step.5", "step.6", "", "view.fit", "reference.heatmap",
              "map.residuals", "", "view.theme"}},
            {QObject::tr("&Map"),
             {"reference.nominal", "reference.meshmaps", "reference.mesh", "reference.load", "reference.again", "",
              "map.load", "map.start", "map.transform", "map.register", "", "map.detect"}},
            {QObject::tr("&Candidates"),
             {"candidate.next", "candidate.previous", "candidate.fly", "", "metric.mahalanobis", "metric.euclidean",
              "metric.chi-square", "candidate.paper", "", "threshold.down", "threshold.up", "threshold.down.coarse",
              "threshold.up.coarse"}},
            {QObject::tr("&Robot"),
             {"robot.builtin",
              "robot.world",
              "visit.grid",
              "",
              "route.robot",
              "route.load",
              "route.save",
              "route.drive",
              "route.map",
              "",
              "visit.plan",
              "visit.earlier",
              "visit.later",
              "visit.remove",
              "",
              "visit.start",
              "visit.pause",
              "visit.toggle",
              "visit.skip",
              "visit.retry",
              "",
              "robot.stop"}},
            {QObject::tr("&Report"), {"label.next", "label.set", "", "report.issue"}},
            {QObject::tr("&Help"), {"help.manual", "help.keys", "help.palette"}}};
}

QString toolTipOf(const Command& command) {
    const QString key = command.shortcut().toString(QKeySequence::NativeText);
    const QString tip = key.isEmpty() ? command.toolTip() : QStringLiteral("%1 (%2)").arg(command.toolTip(), key);
    const QString obstacle = command.isEnabled() ? QString() : command.obstacle();
    return obstacle.isEmpty() ? tip : QObject::tr("%1\nNot now: %2").arg(tip, obstacle);
}

void follow(QPushButton& button, const Command& action, ButtonRole role) {
    button.setText(action.text());
    // Icons are drawn in the text's colour, which does not show on the accent.
    if (role == ButtonRole::Normal) button.setIcon(action.icon());
    button.setEnabled(action.isEnabled());
    button.setToolTip(toolTipOf(action));
    button.setCheckable(action.isCheckable());
    button.setChecked(action.isChecked());
}

}  // namespace

template <typename C, typename... Args>
void CommandSet::add(Args&&... args) {
    commands_.push_back(new C(context_, std::forward<Args>(args)...));
}

CommandSet::CommandSet(CommandContext context, QObject* parent) : QObject(parent), context_(context) {
    add<NewInspectionCommand>();
    add<OpenSessionCommand>();
    add<BuiltinTankCommand>();
    add<CloseInspectionCommand>();
    add<QuitCommand>();
    add<UndoCommand>();
    add<RedoCommand>();
    add<CancelTaskCommand>();
    add<LoadMeshCommand>();
    add<LoadMeshAndMapsCommand>();
    add<LoadReferenceCommand>();
    add<RemakeReferenceCommand>();
    add<LoadNominalMapsCommand>();
    add<LoadMapCommand>();
    add<LoadTransformCommand>();
    add<StartPoseCommand>();
    add<ForgetTransformCommand>();
    add<ResidualsCommand>();
    add<DetectCommand>();
    add<HeatMapCommand>();
    add<NeighbourCandidateCommand>(+1);
    add<NeighbourCandidateCommand>(-1);
    add<FlyToCandidateCommand>();
    for (const bool coarse : {false, true})
        for (const int step : {+1, -1})
            add<StepThresholdCommand>(step, coarse);
    add<UseMetricCommand>(Metric::Mahalanobis);
    add<UseMetricCommand>(Metric::Euclidean);
    add<UseMetricCommand>(Metric::ChiSquare);
    add<PaperSettingsCommand>();
    add<TuningCommand>();
    add<LoadRouteCommand>();
    add<SaveRouteCommand>();
    add<ConnectMappingRobotCommand>();
    add<DriveRouteCommand>();
    add<FetchMapCommand>();
    add<LoadGridCommand>();
    add<ConnectWorldRobotCommand>();
    add<ConnectBuiltinRobotCommand>();
    add<PlanVisitsCommand>();
    add<ShiftWaypointCommand>(-1);
    add<ShiftWaypointCommand>(+1);
    add<RemoveWaypointCommand>();
    add<StartVisitsCommand>();
    add<PauseVisitsCommand>();
    add<TogglePauseCommand>();
    add<SkipVisitCommand>();
    add<RetryVisitCommand>();
    add<StopCommand>();
    for (int step = 0; step < kStepCount; ++step)
        add<GoToStepCommand>(static_cast<Step>(step));
    add<FitViewsCommand>();
    add<ToggleThemeCommand>();
    add<SettingsCommand>();
    add<ManualCommand>();
    add<ShortcutsCommand>();
    add<PaletteCommand>();
    add<LeaveCommand>();
    add<NextUndecidedCommand>();
    add<LoadLabelSetCommand>();
    add<IssueReportCommand>();

    const auto& controller = context_.controller;
    for (const auto signal : {&InspectionController::sessionChanged, &InspectionController::referenceChanged,
                              &InspectionController::mapChanged, &InspectionController::parametersChanged,
                              &InspectionController::candidatesChanged, &InspectionController::planChanged,
                              &InspectionController::visitsChanged, &InspectionController::robotChanged,
                              &InspectionController::decisionsChanged, &InspectionController::historyChanged,
                              &InspectionController::residualsChanged, &InspectionController::stepsChanged,
                              &InspectionController::routeChanged})
        connect(&controller, signal, this, &CommandSet::refreshAll);
    connect(&controller, &InspectionController::selectionChanged, this, &CommandSet::refreshAll);
    connect(&controller, &InspectionController::waypointSelectionChanged, this, &CommandSet::refreshAll);
    refreshAll();
}

CommandSet::~CommandSet() {
    for (Command* command : commands_)
        delete command;
}

Command* CommandSet::find(const QString& id) const {
    for (Command* command : commands_)
        if (command->objectName() == id) return command;
    return nullptr;
}

QPushButton* CommandSet::makeButton(const QString& id, QWidget* parent, ButtonRole role) const {
    auto* button = new QPushButton(parent);
    button->setObjectName(QStringLiteral("button.") + id);
    button->setFocusPolicy(Qt::TabFocus);
    Command* command = find(id);
    setButtonRole(button, role);
    follow(*button, *command, role);
    connect(command, &QAction::changed, button, [button, command, role] { follow(*button, *command, role); });
    connect(button, &QPushButton::clicked, command, [command] { command->trigger(); });
    return button;
}

void CommandSet::fillMenuBar(QMenuBar& menuBar) const {
    for (const MenuPlan& plan : menus()) {
        QMenu* menu = menuBar.addMenu(plan.title);
        for (const QString& id : plan.ids) {
            if (id.isEmpty())
                menu->addSeparator();
            else
                menu->addAction(find(id));
        }
    }
}

void CommandSet::refreshAll() {
    for (Command* command : commands_)
        command->refresh();
}

}  // namespace fodscope
