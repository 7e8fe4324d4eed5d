// SPDX-License-Identifier: MIT
#include "ui/window/PlanBinding.h"

#include <algorithm>
#include <cmath>

#include "ui/commands/StopChanges.h"
#include "ui/panels/Format.h"
#include "ui/plan/PlanGeometry.h"

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
        if (isRoute_)
            controller_.selectRoutePose(id);
        else
            controller_.selectWaypoint(id);
    });
    connect(&controller, &InspectionController::waypointSelectionChanged, this, [this](const QString& id) {
        if (!isRoute_) view_.setSelectedWaypoint(id);
    });
    connect(&controller, &InspectionController::visitsChanged, this, &PlanBinding::refreshEditable);
    connect(&view, &PlanView::waypointMoved, this, &PlanBinding::move);
    connect(&view, &PlanView::waypointAdded, this, &PlanBinding::add);
    connect(&view, &PlanView::waypointRemoved, this, [this](const QString& id) { removeStop(controller_, id); });
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
    refreshEditable();
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
    refreshEditable();
}

void PlanBinding::refreshEditable() {
    view_.setEditable(!isRoute_ && controller_.state().plan && !controller_.candidatesAreFrozen());
}

void PlanBinding::move(const QString& waypointId, const Eigen::Vector2d& place_map) {
    const auto& waypoints = view_.scene().waypoints;
    const auto moved = std::ranges::find(waypoints, waypointId.toStdString(), &PlanWaypoint::id);
    std::vector<PlannedStop> stops = controller_.stops();
    const auto index = static_cast<std::size_t>(moved - waypoints.begin());
    if (moved == waypoints.end() || index >= stops.size()) return;
    stops[index] = {{place_map.x(), place_map.y(), facingFrom(view_.scene(), *moved, place_map)}, {}};
    controller_.changeStops(stops, tr("move of %1").arg(waypointId));
}

void PlanBinding::add(const Eigen::Vector2d& place_map) {
    const auto& candidates = view_.scene().candidates;
    const auto nearest = std::ranges::min_element(
        candidates, {}, [&](const PlanCandidate& candidate) { return (candidate.centroid_map - place_map).norm(); });
    if (nearest == candidates.end()) return;
    const Eigen::Vector2d way = nearest->centroid_map - place_map;
    std::vector<PlannedStop> stops = controller_.stops();
    stops.push_back({{place_map.x(), place_map.y(), std::atan2(way.y(), way.x())}, {}});
    controller_.changeStops(stops, tr("new waypoint"));
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
