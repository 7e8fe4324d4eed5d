// SPDX-License-Identifier: MIT
#include "ui/window/Centre.h"

#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "ui/commands/CommandSet.h"
#include "ui/labelling/LabellingView.h"
#include "ui/panels/MessageBanner.h"
#include "ui/panels/StartPage.h"
#include "ui/plan/PlanView.h"
#include "ui/report/ReportPreview.h"
#include "ui/view3d/View3D.h"
#include "ui/widgets/EmptyState.h"
#include "ui/window/LabellingBinding.h"
#include "ui/window/PlanBinding.h"
#include "ui/window/SceneBinding.h"

namespace fodscope {
namespace {

/// Laying the report out takes a moment; several changes at once are laid out together.
constexpr int kReportDelay_ms = 200;
/// In a narrower view its tool bar would lie over the legend.
constexpr int kToolBarFrom_px = 520;

}  // namespace

Centre::Centre(InspectionController& controller, const CommandSet& commands, QWidget* parent)
    : QWidget(parent), controller_(controller), commands_(commands) {
    setSurface(this, SurfaceRole::Surface0);
    banner_ = new MessageBanner(this);
    stack_ = new QStackedWidget(this);
    start_ = new StartPage(commands, stack_);
    empty_ = new EmptyState(stack_);
    empty_->setObjectName(QStringLiteral("centre.empty"));
    scene_ = new QSplitter(Qt::Horizontal, stack_);
    scene_->setObjectName(QStringLiteral("centre.scene"));
    view_ = new View3D(scene_);
    view_->setObjectName(QStringLiteral("view3d"));
    plan_ = new PlanView(scene_);
    plan_->setObjectName(QStringLiteral("planView"));
    scene_->addWidget(view_);
    scene_->addWidget(plan_);
    scene_->setChildrenCollapsible(true);
    scene_->setSizes({500, 500});
    labelling_ = new LabellingView(stack_);
    labelling_->setObjectName(QStringLiteral("labellingView"));
    report_ = new ReportPreview(stack_);
    report_->setObjectName(QStringLiteral("reportPreview"));
    for (QWidget* page : {static_cast<QWidget*>(start_), static_cast<QWidget*>(empty_), static_cast<QWidget*>(scene_),
                          static_cast<QWidget*>(labelling_), static_cast<QWidget*>(report_)})
        stack_->addWidget(page);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(banner_);
    column->addWidget(stack_, 1);

    sceneBinding_ = new SceneBinding(controller, *view_, this);
    planBinding_ = new PlanBinding(controller, *plan_, this);
    new LabellingBinding(controller, *labelling_, this);

    connect(&controller, &InspectionController::errorRaised, banner_, &MessageBanner::showError);
    connect(&controller.tasks(), &TaskRunner::started, banner_, &MessageBanner::dismiss);
    connect(&controller.tasks(), &TaskRunner::progressed, this, &Centre::showTask);
    connect(scene_, &QSplitter::splitterMoved, this, &Centre::fitToolBar);
    connect(empty_, &EmptyState::activated, this, [this] {
        if (Command* command = commands_.find(need_.commandId)) command->trigger();
    });
    connect(empty_, &EmptyState::secondActivated, this, [this] {
        if (Command* command = commands_.find(need_.secondCommandId)) command->trigger();
    });
    for (const auto signal :
         {&InspectionController::sessionChanged, &InspectionController::referenceChanged,
          &InspectionController::mapChanged, &InspectionController::detectionChanged,
          &InspectionController::photosChanged, &InspectionController::decisionsChanged,
          &InspectionController::headerChanged, &InspectionController::planChanged, &InspectionController::stepsChanged,
          &InspectionController::routeChanged, &InspectionController::robotChanged})
        connect(&controller, signal, this, &Centre::refresh);
    for (const auto signal : {&InspectionController::sessionChanged, &InspectionController::detectionChanged,
                              &InspectionController::photosChanged, &InspectionController::decisionsChanged,
                              &InspectionController::headerChanged, &InspectionController::planChanged,
                              &InspectionController::visitsChanged})
        connect(&controller, signal, this, [this] {
            reportIsOld_ = true;
            if (step_ == Step::Report) reportDelay_.start();
        });
    reportDelay_.setSingleShot(true);
    reportDelay_.setInterval(kReportDelay_ms);
    connect(&reportDelay_, &QTimer::timeout, this, &Centre::layOutReport);
    refresh();
}

void Centre::setStep(Step step) {
    step_ = step;
    sceneBinding_->setStep(step);
    planBinding_->setStep(step);
    refresh();
    if (step == Step::Report && reportIsOld_) reportDelay_.start();
    if (stack_->currentWidget() == labelling_) labelling_->setFocus();
}

void Centre::refresh() {
    if (!controller_.isOpen()) {
        stack_->setCurrentWidget(start_);
        return;
    }
    if (const auto need = needOf(step_, controller_)) {
        showNeed(*need);
        return;
    }
    plan_->setVisible(step_ == Step::Visit || (step_ == Step::Map && controller_.isRouteWanted()));
    QWidget* page = step_ == Step::Label    ? static_cast<QWidget*>(labelling_)
                    : step_ == Step::Report ? static_cast<QWidget*>(report_)
                                            : scene_;
    if (stack_->currentWidget() != page) stack_->setCurrentWidget(page);
    // The splitter gives its parts their widths in its next layout.
    if (page == scene_) QMetaObject::invokeMethod(this, &Centre::fitToolBar, Qt::QueuedConnection);
}

void Centre::showNeed(const StepNeed& need) {
    need_ = need;
    stack_->setCurrentWidget(empty_);
    if (controller_.tasks().isBusy()) return;
    empty_->showEmpty(need.picture, need.sentence, need.buttonText);
    empty_->setSecondButton(need.secondText);
}

void Centre::showTask(const TaskReport& report) {
    if (stack_->currentWidget() != empty_) return;
    empty_->showLoading(report.stage, report.fraction);
    empty_->setSecondButton({});
}

void Centre::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitToolBar();
}

void Centre::fitToolBar() {
    view_->setToolBarVisible(view_->width() >= kToolBarFrom_px);
}

void Centre::setHeatMap(bool shown) {
    sceneBinding_->setHeatMap(shown);
}

void Centre::setResiduals(bool shown) {
    sceneBinding_->setResiduals(shown);
}

void Centre::fitViews() {
    view_->fit();
    plan_->fit();
}

void Centre::layOutReport() {
    if (!controller_.state().detection) {
        report_->clear();
        return;
    }
    reportIsOld_ = false;
    report_->setReport(controller_.state(), controller_.headHash().toStdString());
}

}  // namespace fodscope
