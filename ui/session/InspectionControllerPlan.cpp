// SPDX-License-Identifier: MIT
// The operator's changes to the plan.
#include <algorithm>

#include "core/common/Error.h"
#include "ui/session/InspectionController.h"

namespace fodscope {

std::vector<PlannedStop> InspectionController::stops() const {
    return state().plan ? stopsOf(*state().plan) : std::vector<PlannedStop>();
}

void InspectionController::changeStops(const std::vector<PlannedStop>& stops, const QString& what) {
    const bool isAllowed = attempt([&] {
        if (!state().plan || !state().grid_map) throw Error("plan", "there is none yet", "plan the visits first");
        if (candidatesAreFrozen())
            throw Error("plan", "it is frozen because the visits have begun", "start a new inspection for another one");
    });
    if (!isAllowed) return;
    InspectionState input;
    input.parameters = state().parameters;
    input.detection = state().detection;
    input.grid_map = state().grid_map;
    input.plan = state().plan;
    runFor(Step::Visit, tr("changing the plan"),
           [this, input = std::move(input), stops, what](Progress& progress) -> TaskRunner::Adopt {
               const VisitPlan plan = replanInspection(input, stops, progress);
               return [this, plan, before = *input.plan, grid = std::make_shared<const OccupancyGrid>(*input.grid_map),
                       what] {
                   keepPlan(*grid, plan);
                   history_.add({what, [this, grid, before] { keepPlan(*grid, before); },
                                 [this, grid, plan] { keepPlan(*grid, plan); }});
                   emit historyChanged();
               };
           });
}

void InspectionController::selectWaypoint(const QString& id) {
    if (id == selectedWaypoint_) return;
    selectedWaypoint_ = id;
    emit waypointSelectionChanged(id);
    if (!state().plan) return;
    const auto waypoint = std::ranges::find(state().plan->waypoints, id.toStdString(), &Waypoint::id);
    if (waypoint == state().plan->waypoints.end() || waypoint->candidateIds.empty()) return;
    const auto& ids = waypoint->candidateIds;
    if (std::ranges::find(ids, selected_.toStdString()) == ids.end())
        selectCandidate(QString::fromStdString(ids.front()));
}

void InspectionController::keepPlan(const OccupancyGrid& grid, const VisitPlan& plan) {
    inspection_->adoptPlan(grid, plan);
    isOnRoute_ = false;
    visits_.setPlan(plan, state().visits, state().parameters.visits, photoMarks(state()));
    refreshVerdicts();
    emit planChanged();
    emit visitsChanged();
    emit stepsChanged();
}

}  // namespace fodscope
