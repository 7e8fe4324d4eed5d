// SPDX-License-Identifier: MIT
#include "ui/window/PlanBinding.h"

#include <algorithm>

#include "ui/panels/Format.h"

namespace fodscope {

PlanBinding::PlanBinding(InspectionController& controller, PlanView& view, QObject* parent)
    : QObject(parent), controller_(controller), view_(view) {
    for (const auto signal : {&InspectionController::sessionChanged, &InspectionController::detectionChanged,
                              &InspectionController::planChanged, &InspectionController::decisionsChanged})
        connect(&controller, signal, this, &PlanBinding::showPlan);
    connect(&controller, &InspectionController::visitsChanged, this,
            [this] { view_.setVisits(controller_.state().visits); });
    connect(&controller, &InspectionController::robotChanged, this, &PlanBinding::showRobot);
    connect(&controller, &InspectionController::selectionChanged, this, [this](const QString& id) {
        view_.setSelectedCandidate(id);
        selectWaypoint();
    });
    connect(&view, &PlanView::candidateSelected, &controller, &InspectionController::selectCandidate);
    connect(&view, &PlanView::candidateActivated, &controller, &InspectionController::flyToCandidate);
    connect(&view, &PlanView::waypointSelected, this, [this](const QString& id) {
        const auto& plan = controller_.state().plan;
        if (!plan) return;
        const auto chosen = std::ranges::find(plan->waypoints, id.toStdString(), &Waypoint::id);
        if (chosen != plan->waypoints.end() && !chosen->candidateIds.empty())
            controller_.selectCandidate(QString::fromStdString(chosen->candidateIds.front()));
    });
    ageTimer_.setInterval(1000);
    connect(&ageTimer_, &QTimer::timeout, this, &PlanBinding::showRobot);
    ageTimer_.start();
    showPlan();
}

void PlanBinding::showPlan() {
    view_.setScene(planScene(controller_.state()));
    view_.setSelectedCandidate(controller_.selectedCandidate());
    selectWaypoint();
    showRobot();
}

void PlanBinding::showRobot() {
    const auto& robot = controller_.visits().robotState();
    if (!robot || !robot->pose_map) {
        view_.setRobot(std::nullopt);
        return;
    }
    view_.setRobot(PlanRobot{*robot->pose_map, std::max(0.0, controller_.visits().now_s() - robot->poseMeasured_s)});
}

void PlanBinding::selectWaypoint() {
    const Waypoint* waypoint = waypointOf(controller_.state(), controller_.selectedCandidate().toStdString());
    view_.setSelectedWaypoint(waypoint && waypoint->pose_map ? QString::fromStdString(waypoint->id) : QString());
}

}  // namespace fodscope
