// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/common/Error.h"
#include "core/evaluation/GroundTruth.h"
#include "core/inspection/DetectionPipeline.h"
#include "core/reference/ReferenceMap.h"

namespace fodscope {

/// How a trial's map comes to lie on the reference.
enum class TrialPlacement {
    Registered,  ///< by the program's own registration, from T_cad_from_map_initial where there is one
    Stored       ///< by its T_cad_from_map
};

/// Which of a folder's maps are measured.
struct TrialSelection {
    /// Those with FOD, in the given order.
    std::vector<const Trial*> withFod;
    /// Names of the maps without FOD, which are left out of every figure.
    std::vector<std::string> nominalMaps;
};

/// @throws Error when no trial has FOD, or naming those that lack the transform by which they are to be placed
TrialSelection selectTrials(std::span<const Trial> trials, TrialPlacement placement);

/// A pipeline with the trial's map, read and placed, ready to run.
/// @throws Error naming the map that cannot be read or used
DetectionPipeline pipelineFor(const Trial& trial, const std::shared_ptr<const ReferenceMap>& reference,
                              TrialPlacement placement);

/// Throws an Error about "map" anew with the name of the trial's file, and everything else as it is.
[[noreturn]] void rethrowNaming(const Trial& trial, const Error& error);

}  // namespace fodscope
