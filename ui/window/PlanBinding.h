// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QTimer>

#include "ui/plan/PlanView.h"
#include "ui/session/InspectionController.h"

namespace fodscope {

/// Keeps the 2D plan showing what the inspection holds, and carries clicks back.
class PlanBinding : public QObject {
    Q_OBJECT

  public:
    PlanBinding(InspectionController& controller, PlanView& view, QObject* parent);

    /// In the map's step the inspection route, else the plan.
    void setStep(Step step);

  private:
    void showPlan();
    void showRoute();
    void connectRoute();
    void showRobot();
    void selectWaypoint();
    void refreshEditable();
    void move(const QString& waypointId, const Eigen::Vector2d& place_map);
    void add(const Eigen::Vector2d& place_map);

    InspectionController& controller_;
    PlanView& view_;
    bool isRoute_ = false;
    QTimer ageTimer_;
};

}  // namespace fodscope
