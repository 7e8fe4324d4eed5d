// SPDX-License-Identifier: MIT
#include "ui/panels/RouteCard.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <algorithm>

#include "ui/commands/CommandSet.h"
#include "ui/panels/Format.h"
#include "ui/panels/PanelParts.h"
#include "ui/widgets/StatusChip.h"

namespace fodscope {
namespace {

QString poseText(const Pose2& pose) {
    return QObject::tr("%1, %2 m, %3°")
        .arg(QString::number(pose.x_m, 'f', 2), QString::number(pose.y_m, 'f', 2),
             QString::number(degreesFromRadians(pose.yaw_rad), 'f', 0));
}

StateText routeText(const InspectionController& controller) {
    const std::vector<Visit>& visits = controller.state().routeVisits;
    if (controller.isDrivingRoute()) return {StatusKind::Running, QObject::tr("driving")};
    if (visits.empty()) return {StatusKind::ToDo, QObject::tr("no poses")};
    if (std::ranges::all_of(visits, isOver, &Visit::state)) return {StatusKind::Clear, QObject::tr("driven")};
    const bool hasBegun = std::ranges::any_of(visits, [](const Visit& visit) { return visit.tries > 0; });
    return hasBegun ? StateText{StatusKind::Attention, QObject::tr("interrupted")}
                    : StateText{StatusKind::ToDo, QObject::tr("not driven")};
}

/// A route's pose is driven to, photographed only where that was asked for.
StateText poseState(const Visit& visit, bool takesPhoto) {
    StateText text = stateText(visit);
    if (visit.state == VisitState::Done && !takesPhoto) text.word = QObject::tr("driven");
    if (visit.state == VisitState::Draft && visit.reason == VisitReason::None) text.word = QObject::tr("to drive");
    return text;
}

}  // namespace

RouteCard::RouteCard(InspectionController& controller, const CommandSet& commands, QWidget* parent)
    : Card(tr("Inspection route"), parent), controller_(controller) {
    setObjectName(QStringLiteral("route.card"));
    chip_ = new StatusChip(this);
    addHeaderWidget(chip_);
    hint_ = makeText({}, TextRole::Muted, this);
    hint_->setObjectName(QStringLiteral("route.hint"));
    body()->addWidget(hint_);
    body()->addWidget(commands.makeButton(QStringLiteral("route.robot"), this));
    makeList();
    body()->addWidget(commands.makeButton(QStringLiteral("route.drive"), this, ButtonRole::Primary));
    auto* files = new QGridLayout;
    files->addWidget(commands.makeButton(QStringLiteral("route.load"), this), 0, 0);
    files->addWidget(commands.makeButton(QStringLiteral("route.save"), this), 0, 1);
    files->addWidget(commands.makeButton(QStringLiteral("route.map"), this), 1, 0, 1, 2);
    body()->addLayout(files);
    for (const auto signal :
         {&InspectionController::sessionChanged, &InspectionController::routeChanged,
          &InspectionController::visitsChanged, &InspectionController::robotChanged, &InspectionController::mapChanged})
        connect(&controller, signal, this, &RouteCard::refresh);
    connect(&controller, &InspectionController::routePoseSelected, this, &RouteCard::refresh);
    refresh();
}

void RouteCard::makeList() {
    list_ = new QTreeWidget(this);
    list_->setObjectName(QStringLiteral("route.list"));
    list_->setHeaderLabels({QString(), QString(), QString()});
    list_->setHeaderHidden(true);
    list_->header()->setMinimumSectionSize(24);
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setMinimumHeight(120);
    list_->setFrameShape(QFrame::NoFrame);
    list_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    body()->addWidget(list_);
    connect(list_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (filling_) return;
        controller_.selectRoutePose(item == nullptr ? QString() : item->data(0, Qt::UserRole).toString());
    });
    poseButtons_ = new QWidget(this);
    auto* row = new QGridLayout(poseButtons_);
    row->setContentsMargins(0, 0, 0, 0);
    up_ = makePoseButton(QStringLiteral("route.up"), tr("Earlier"), tr("Drives to the selected pose earlier"));
    down_ = makePoseButton(QStringLiteral("route.down"), tr("Later"), tr("Drives to the selected pose later"));
    photo_ = makePoseButton(QStringLiteral("route.photo"), tr("Photo"), tr("Takes a photo at the selected pose"));
    photo_->setCheckable(true);
    remove_ = makePoseButton(QStringLiteral("route.remove"), tr("Remove"), tr("Takes the selected pose out (Delete)"));
    int column = 0;
    for (QPushButton* button : {up_, down_, photo_, remove_})
        row->addWidget(button, column / 2, column % 2), ++column;
    body()->addWidget(poseButtons_);
    connect(up_, &QPushButton::clicked, this, [this] { move(-1); });
    connect(down_, &QPushButton::clicked, this, [this] { move(+1); });
    connect(photo_, &QPushButton::clicked, this, &RouteCard::togglePhoto);
    connect(remove_, &QPushButton::clicked, this, &RouteCard::remove);
}

QPushButton* RouteCard::makePoseButton(const QString& name, const QString& text, const QString& toolTip) {
    auto* button = new QPushButton(text, poseButtons_);
    button->setObjectName(name);
    button->setToolTip(toolTip);
    button->setFocusPolicy(Qt::TabFocus);
    setButtonRole(button, ButtonRole::Normal);
    return button;
}

void RouteCard::refresh() {
    const InspectionState& state = controller_.state();
    const StateText text = routeText(controller_);
    chip_->setStatus(text.kind, text.word);
    hint_->setText(controller_.routeGrid() == nullptr
                       ? tr("Where the robot drives while it maps. Connect a robot, or load a grid in step 4, to see "
                            "the plan; a route can be loaded without.")
                       : tr("Double-click the plan to add a pose, drag it to move it, drag its handle to turn it."));
    filling_ = true;
    list_->clear();
    QTreeWidgetItem* chosen = nullptr;
    for (std::size_t i = 0; i < state.route.poses.size(); ++i) {
        const RoutePose& pose = state.route.poses[i];
        const Visit* visit = findVisit(state, pose.id);
        const StateText word = visit ? poseState(*visit, pose.takesPhoto) : StateText{};
        auto* item = new QTreeWidgetItem(list_, {QString::number(i + 1), poseText(pose.pose_map), word.word});
        item->setForeground(2, statusColour(currentTheme(), word.kind));
        item->setData(0, Qt::UserRole, QString::fromStdString(pose.id));
        if (visit) item->setToolTip(2, QString::fromStdString(reasonText(*visit)));
        if (item->data(0, Qt::UserRole).toString() == controller_.selectedRoutePose()) chosen = item;
    }
    list_->setCurrentItem(chosen);
    list_->setVisible(!state.route.poses.empty());
    filling_ = false;
    refreshButtons();
}

void RouteCard::refreshButtons() {
    const int row = selectedRow();
    const int last = static_cast<int>(controller_.state().route.poses.size()) - 1;
    const bool editable = row >= 0 && !controller_.isDrivingRoute();
    poseButtons_->setVisible(last >= 0);
    up_->setEnabled(editable && row > 0);
    down_->setEnabled(editable && row < last);
    photo_->setEnabled(editable);
    photo_->setChecked(row >= 0 && controller_.state().route.poses[static_cast<std::size_t>(row)].takesPhoto);
    remove_->setEnabled(editable);
}

int RouteCard::selectedRow() const {
    return list_->currentItem() == nullptr ? -1 : list_->indexOfTopLevelItem(list_->currentItem());
}

void RouteCard::move(int step) {
    const int row = selectedRow();
    InspectionRoute route = controller_.state().route;
    if (row < 0 || row + step < 0 || row + step >= static_cast<int>(route.poses.size())) return;
    std::swap(route.poses[static_cast<std::size_t>(row)], route.poses[static_cast<std::size_t>(row + step)]);
    controller_.setRoute(route, tr("order of the route"));
}

void RouteCard::remove() {
    controller_.removeRoutePose(controller_.selectedRoutePose());
}

void RouteCard::togglePhoto() {
    const int row = selectedRow();
    if (row < 0) return;
    InspectionRoute route = controller_.state().route;
    RoutePose& pose = route.poses[static_cast<std::size_t>(row)];
    pose.takesPhoto = !pose.takesPhoto;
    controller_.setRoute(route, tr("photo at a pose"));
}

}  // namespace fodscope
