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

/// Those and --metric, --linkage, --crop-height: all but what a parameter search finds
void addMethodOptions(CLI::App& command, ParameterOptions& options);

/// Those and --threshold, --cluster-cutoff, --min-points
void addDetectionParameterOptions(CLI::App& command, ParameterOptions& options);

/// @throws Error for the file, UsageError for single options out of range, all of them told at once
Parameters parametersOf(const ParameterOptions& options);

/// The same before the single options are judged, for commands that lay options of their own over them.
Parameters unjudgedParametersOf(const ParameterOptions& options);

/// @throws UsageError that lists everything wrong with the parameters
void requireValid(const Parameters& parameters);

}  // namespace fodscope::cli
