// SPDX-License-Identifier: MIT
#include "app/cli/ParameterOptions.h"

#include <CLI/CLI.hpp>

#include "app/cli/Context.h"
#include "core/inspection/ParameterTable.h"

namespace fodscope::cli {

void addPresetOptions(CLI::App& command, ParameterOptions& options) {
    command.add_option("--preset", options.preset, "named set of parameters to start from")
        ->check(CLI::IsMember(presetNames()))
        ->capture_default_str();
    command.add_option("--params", options.file, "YAML file over the preset")->type_name("FILE");
}

void addMethodOptions(CLI::App& command, ParameterOptions& options) {
    addPresetOptions(command, options);
    command.add_option("--metric", options.metric, "how far a map voxel deviates from the reference")
        ->check(CLI::IsMember(findParameter("candidates", "metric")->choices));
    command.add_option("--linkage", options.linkage, "from where to where the distance of clusters is taken")
        ->check(CLI::IsMember({"centroid", "single"}));
    command
        .add_option("--crop-height", options.cropHeight_m, "points higher than this (reference frame) are dropped [m]")
        ->type_name("Z");
}

void addDetectionParameterOptions(CLI::App& command, ParameterOptions& options) {
    addMethodOptions(command, options);
    command.add_option("--threshold", options.threshold, "discrepancy above which a voxel is discrepant")
        ->type_name("T");
    command.add_option("--cluster-cutoff", options.clusterCutoff_m, "clusters at most this far apart are merged [m]")
        ->type_name("C");
    command.add_option("--min-points", options.minimumPoints, "clusters with fewer voxels are dropped")->type_name("N");
}

Parameters unjudgedParametersOf(const ParameterOptions& options) {
    Parameters parameters = presetParameters(options.preset);
    if (!options.file.empty()) parameters = readParameters(options.file, parameters);
    if (options.metric) findParameter("candidates", "metric")->set(parameters, *options.metric);
    if (options.threshold) parameters.candidates.threshold = *options.threshold;
    if (options.clusterCutoff_m) parameters.candidates.clusterCutoff_m = *options.clusterCutoff_m;
    if (options.linkage) findParameter("candidates", "linkage")->set(parameters, *options.linkage);
    if (options.minimumPoints) parameters.candidates.minimumPoints = *options.minimumPoints;
    if (options.cropHeight_m) parameters.discrepancy.cropHeight_m = *options.cropHeight_m;
    return parameters;
}

void requireValid(const Parameters& parameters) {
    std::string text;
    for (const std::string& problem : parameterProblems(parameters))
        text += (text.empty() ? "" : "; ") + problem;
    if (!text.empty()) throw UsageError(text);
}

Parameters parametersOf(const ParameterOptions& options) {
    Parameters parameters = unjudgedParametersOf(options);
    requireValid(parameters);
    return parameters;
}

}  // namespace fodscope::cli
