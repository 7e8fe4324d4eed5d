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

struct DetectionRun {
    LoadedReferenceMap reference;
    LoadedMap map;
    Parameters parameters;
    DetectionResult result;
    double loadSeconds = 0.0;
};

/// Reads the files and detects.
/// @throws Error naming the file at fault, the map when it cannot be aligned; UsageError; Cancelled
DetectionRun runDetection(const DetectionOptions& options, Context& context);

}  // namespace fodscope::cli
