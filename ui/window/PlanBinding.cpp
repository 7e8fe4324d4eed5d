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
            [this] { view_.setVisits(isRoute_ ? controller_.state().routeVisits : controller_.state().visits); });
    connect(&controller, &InspectionController::robotChanged, this, &PlanBinding::showRobot);
    connect(&controller, &InspectionController::selectionChanged, this, [this](const QString& id) {
        view_.setSelectedCandidate(id);
        selectWaypoint();
    });
    connect(&view, &PlanView::candidateSelected, &controller, &InspectionController::selectCandidate);
    connect(&view, &PlanView::candidateActivated, &controller, &InspectionController::flyToCandidate);
    connectRoute();
    connect(&view, &PlanView::waypointSelected, this, [this](const QString& id) {
        if (isRoute_) {
            controller_.selectRoutePose(id);
            return;
        }
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

void PlanBinding::connectRoute() {
    connect(&controller_, &InspectionController::routeChanged, this, &PlanBinding::showRoute);
    connect(&controller_, &InspectionController::routePoseSelected, this, [this](const QString& id) {
        if (isRoute_) view_.setSelectedWaypoint(id);
    });
    connect(&view_, &PlanView::poseAdded, this, [this](const Pose2& pose_map) {
        InspectionRoute route = controller_.state().route;
        route.poses.push_back({{}, pose_map, false});
        controller_.setRoute(route, tr("pose added"));
    });
    connect(&view_, &PlanView::poseChanged, this, [this](const QString& id, const Pose2& pose_map) {
        InspectionRoute route = controller_.state().route;
        const auto pose = std::ranges::find(route.poses, id.toStdString(), &RoutePose::id);
        if (pose == route.poses.end()) return;
        pose->pose_map = pose_map;
        controller_.setRoute(route, tr("pose moved"));
        // A pose that the robot is at work on stays where it was.
        showRoute();
    });
    connect(&view_, &PlanView::poseRemoved, &controller_, &InspectionController::removeRoutePose);
}

void PlanBinding::setStep(Step step) {
    if (isRoute_ == (step == Step::Map)) return;
    isRoute_ = step == Step::Map;
    showPlan();
}

void PlanBinding::showRoute() {
    if (!isRoute_) return;
    view_.setScene(routeScene(controller_.state(), controller_.routeGrid()));
    view_.setSelectedCandidate({});
    view_.setSelectedWaypoint(controller_.selectedRoutePose());
    showRobot();
}

void PlanBinding::showPlan() {
    if (isRoute_) {
        showRoute();
        return;
    }
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
    if (isRoute_) return;
    const Waypoint* waypoint = waypointOf(controller_.state(), controller_.selectedCandidate().toStdString());
    view_.setSelectedWaypoint(waypoint && waypoint->pose_map ? QString::fromStdString(waypoint->id) : QString());
}

}  // namespace fodscope
