// SPDX-License-Identifier: MIT
#include "ui/session/Steps.h"

#include <algorithm>
#include <set>

namespace fodscope {
namespace {

StepState mapState(const InspectionState& state) {
    if (!state.mapSource) return StepState::ToDo;
    if (!state.detection) return StepState::NeedsLook;
    return isTrusted(state.detection->registration.quality) ? StepState::Done : StepState::NeedsLook;
}

StepState candidatesState(const InspectionState& state) {
    if (!state.detection || !state.detection->candidates) return StepState::ToDo;
    // Until a plan is made from them somebody should look whether these are the candidates wanted.
    return state.plan ? StepState::Done : StepState::NeedsLook;
}

bool isSettled(const Visit& visit) {
    return visit.state == VisitState::Done || visit.state == VisitState::Skipped;
}

StepState visitState(const InspectionState& state) {
    if (!state.plan) return StepState::ToDo;
    return std::all_of(state.visits.begin(), state.visits.end(), isSettled) ? StepState::Done : StepState::NeedsLook;
}

StepState labelState(const InspectionState& state) {
    if (state.photos.empty()) return StepState::ToDo;
    return photosWithoutDecision(state).empty() ? StepState::Done : StepState::NeedsLook;
}

StepState reportState(const InspectionState& state) {
    if (!state.detection) return StepState::ToDo;
    return state.reports.empty() ? StepState::ToDo : StepState::Done;
}

}  // namespace

std::vector<std::string> photosWithoutDecision(const InspectionState& state) {
    std::set<std::string> readers;
    for (const Decision& decision : state.decisions)
        readers.insert(decision.labeller);
    std::vector<std::string> waiting;
    for (const Photo& photo : state.photos) {
        const bool decided = std::any_of(readers.begin(), readers.end(), [&](const std::string& reader) {
            return lastDecision(state.decisions, photo.id, reader) != nullptr;
        });
        if (!decided) waiting.push_back(photo.id);
    }
    return waiting;
}

std::array<StepState, kStepCount> stepStates(const InspectionState& state) {
    return {state.reference ? StepState::Done : StepState::ToDo,
            mapState(state),
            candidatesState(state),
            visitState(state),
            labelState(state),
            reportState(state)};
}

Step firstOpenStep(const InspectionState& state) {
    const auto states = stepStates(state);
    for (int i = 0; i < kStepCount; ++i)
        if (states[static_cast<std::size_t>(i)] != StepState::Done) return static_cast<Step>(i);
    return Step::Report;
}

}  // namespace fodscope
