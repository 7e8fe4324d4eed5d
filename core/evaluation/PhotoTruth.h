// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/common/Progress.h"
#include "core/evaluation/ReaderAgreement.h"

namespace fodscope {

/// @return whether a labeller's name is one of those under which the simulation labels photos by itself
bool isSimulatedLabeller(const std::string& name);

/// What the photos of a session show in the world that they were taken in. A FOD whose type the session's label set
/// has no label for is `other FOD` where the set has that, else it goes by its type.
/// @throws Error when the world cannot be read; Cancelled
ActualLabels actualLabelsIn(const std::filesystem::path& worldFile, const InspectionState& state, Progress& progress);

/// What a simulated labeller recorded in the session.
/// @return empty when none did
std::optional<ActualLabels> recordedActualLabels(const InspectionState& state);

}  // namespace fodscope
