// SPDX-License-Identifier: MIT
#pragma once

#include <QTimer>
#include <QWidget>

class QLabel;

namespace fodscope {

class CommandSet;
class InspectionController;
class StatusChip;
class TaskBar;

/// The row that never hides: robot with the age of its pose, the running task, counts, STOP.
class StatusStrip : public QWidget {
    Q_OBJECT

  public:
    StatusStrip(InspectionController& controller, const CommandSet& commands, QWidget* parent = nullptr);

  private:
    void refreshRobot();
    void refreshCounts();

    InspectionController& controller_;
    StatusChip* robot_ = nullptr;
    TaskBar* task_ = nullptr;
    QLabel* counts_ = nullptr;
    QTimer ageTimer_;
    QTimer taskDelay_;
};

}  // namespace fodscope
