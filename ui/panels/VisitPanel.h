// SPDX-License-Identifier: MIT
#pragma once

#include <QTimer>
#include <tuple>

#include "ui/panels/PanelParts.h"

class QDoubleSpinBox;
class QProgressBar;
class QTreeWidget;
class QTreeWidgetItem;

namespace fodscope {

class Card;
class CommandSet;
class InspectionController;
class StatusChip;

/// Step 4: the robot, the plan, and the drive through it.
class VisitPanel : public PanelColumn {
    Q_OBJECT

  public:
    VisitPanel(InspectionController& controller, const CommandSet& commands, QWidget* parent = nullptr);

  private:
    void makeRobotCard(const CommandSet& commands);
    void makePlanCard(const CommandSet& commands);
    void makeDriveCard(const CommandSet& commands);
    void makePreviewCard();
    void refreshPreview();
    void refresh();
    void refreshRobot();
    void refreshPlan();
    void refreshVisits();
    void selectRow();
    void tellStory();
    void takeStart();

    InspectionController& controller_;
    Card* robot_ = nullptr;
    StatusChip* link_ = nullptr;
    FieldList* robotFields_ = nullptr;
    QWidget* start_ = nullptr;
    QDoubleSpinBox* startX_ = nullptr;
    QDoubleSpinBox* startY_ = nullptr;
    QDoubleSpinBox* startYaw_ = nullptr;
    std::vector<QWidget*> connectButtons_;
    QLabel* planHint_ = nullptr;
    FieldList* planFields_ = nullptr;
    Card* drive_ = nullptr;
    StatusChip* runner_ = nullptr;
    QLabel* told_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QTreeWidget* list_ = nullptr;
    QLabel* story_ = nullptr;
    Card* preview_ = nullptr;
    QLabel* picture_ = nullptr;
    /// What the preview shows: pose, candidates, theme.
    std::tuple<double, double, double, const void*, ThemeKind> previewed_{};
    bool filling_ = false;
    QTimer ageTimer_;
};

}  // namespace fodscope
