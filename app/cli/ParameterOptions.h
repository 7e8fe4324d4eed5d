// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "core/inspection/Parameters.h"

namespace CLI {
class App;
}

namespace fodscope::cli {

/// The options that make up the parameters: a preset, a file over it, single options over both.
struct ParameterOptions {
    std::string preset = "paper-physical";
    std::string file;
    std::optional<std::string> metric;
    std::optional<double> threshold;
    std::optional<double> clusterCutoff_m;
    std::optional<std::string> linkage;
    std::optional<int> minimumPoints;
    std::optional<double> cropHeight_m;
};

/// --preset and --params
void addPresetOptions(CLI::App& command, ParameterOptions& options);

/// Those and --metric, --threshold, --cluster-cutoff, --linkage, --min-points, --crop-height
void addDetectionParameterOptions(CLI::App& command, ParameterOptions& options);

/// @throws Error for the file, UsageError for a single option out of range
Parameters parametersOf(const ParameterOptions& options);

}  // namespace fodscope::cli
