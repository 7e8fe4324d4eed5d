// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/inspection/InspectionState.h"

namespace fodscope {

/// The six steps of an inspection, in the order of the work.
enum class Step { Reference, Map, Candidates, Visit, Label, Report };
inline constexpr int kStepCount = 6;

enum class StepState {
    ToDo,       ///< nothing there yet
    Running,    ///< a task works on it
    NeedsLook,  ///< something there waits for a person
    Done
};

/// What the state of an inspection says about each step; `Running` is laid over it by whoever runs tasks.
std::array<StepState, kStepCount> stepStates(const InspectionState& state);

/// @return the first step that is not done, where a reopened session goes on when nothing better is remembered
Step firstOpenStep(const InspectionState& state);

/// Photos on which no reader has a decision that counts, in order of arrival.
std::vector<std::string> photosWithoutDecision(const InspectionState& state);

}  // namespace fodscope
