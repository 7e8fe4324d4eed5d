// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "app/cli/Context.h"
#include "app/cli/Inputs.h"
#include "app/cli/ParameterOptions.h"
#include "core/inspection/DetectionPipeline.h"

namespace fodscope::cli {

/// What the commands that detect candidates have in common.
struct DetectionOptions {
    std::string reference;
    std::string map;
    std::string transform;
    std::string initial;
    ParameterOptions parameters;
};

void addDetectionOptions(CLI::App& command, DetectionOptions& options);

/// Whether the map as it was read is needed after the detection, beside the one without outliers.
enum class AfterDetection { KeepMap, DropMap };

struct DetectionRun {
    LoadedReferenceMap reference;
    /// Without its cloud when that was dropped.
    LoadedMap map;
    Parameters parameters;
    DetectionResult result;
    double loadSeconds = 0.0;
};

/// Reads the files and detects. There are no candidates when the map's alignment cannot be trusted.
/// @throws Error naming the file at fault; UsageError; Cancelled
DetectionRun runDetection(const DetectionOptions& options, Context& context, AfterDetection after);

/// @throws Error naming the map when it could not be aligned, or in several ways
void requireTrustedAlignment(const DetectionRun& run, const std::string& mapFile);

}  // namespace fodscope::cli
