// SPDX-License-Identifier: MIT
#pragma once

#include <QTimer>
#include <QWidget>

#include "ui/window/StepNeeds.h"

class QSplitter;
class QStackedWidget;

namespace fodscope {

class CommandSet;
class EmptyState;
class LabellingView;
class MessageBanner;
class PlanBinding;
class PlanView;
class ReportPreview;
class SceneBinding;
class StartPage;
class View3D;

/// The middle of the window: start page, 3D view with the plan beside it, photo, report; the banner over all of them.
class Centre : public QWidget {
    Q_OBJECT

  public:
    Centre(InspectionController& controller, const CommandSet& commands, QWidget* parent = nullptr);

    void setStep(Step step);
    MessageBanner& banner() { return *banner_; }
    View3D& view() { return *view_; }
    PlanView& plan() { return *plan_; }
    LabellingView& labelling() { return *labelling_; }
    StartPage& startPage() { return *start_; }
    void setHeatMap(bool shown);
    void setResiduals(bool shown);
    void fitViews();

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void fitToolBar();
    void refresh();
    void showNeed(const StepNeed& need);
    void showTask(const TaskReport& report);
    void layOutReport();

    InspectionController& controller_;
    const CommandSet& commands_;
    Step step_ = Step::Reference;
    StepNeed need_;
    MessageBanner* banner_ = nullptr;
    QStackedWidget* stack_ = nullptr;
    StartPage* start_ = nullptr;
    EmptyState* empty_ = nullptr;
    QSplitter* scene_ = nullptr;
    View3D* view_ = nullptr;
    PlanView* plan_ = nullptr;
    SceneBinding* sceneBinding_ = nullptr;
    PlanBinding* planBinding_ = nullptr;
    LabellingView* labelling_ = nullptr;
    ReportPreview* report_ = nullptr;
    QTimer reportDelay_;
    bool reportIsOld_ = true;
};

}  // namespace fodscope
