// SPDX-License-Identifier: MIT
#include "app/cli/ReferenceOptions.h"

#include <CLI/CLI.hpp>
#include <ostream>

#include "core/inspection/ParameterTable.h"

namespace fodscope::cli {
namespace {

void setWord(const char* key, const std::optional<std::string>& word, Parameters& parameters) {
    if (word) findParameter(kReferenceSection, key)->set(parameters, *word);
}

void tellWithoutEffect(const ReferenceOptions& options, const SmoothingSettings& settings, std::ostream& remarks) {
    const bool isBall = settings.neighbourhood == SmoothingNeighbourhood::Ball;
    if (options.radius_m && !isBall) remarks << "note: --radius has no effect without --neighbourhood ball\n";
    if (options.neighbours && isBall) remarks << "note: --neighbours has no effect with --neighbourhood ball\n";
    if (options.sigma_m && settings.weights == SmoothingWeights::Mean)
        remarks << "note: --sigma has no effect without --weights gaussian\n";
}

}  // namespace

void addReferenceOptions(CLI::App& command, ReferenceOptions& options) {
    command.add_option("--spacing", options.spacing_m, "area / spacing^2 samples of the mesh [m]")->type_name("S");
    command.add_option("--voxel", options.voxelSize_m, "voxels of the mean [m]")->type_name("V");
    command.add_option("--occupancy-quantile", options.occupancyQuantile, "emptier voxels are dropped")->type_name("Q");
    command.add_option("--weights", options.weights, "weights of the covariance smoothing")
        ->check(CLI::IsMember(findParameter(kReferenceSection, "covariance_weights")->choices));
    command.add_option("--neighbourhood", options.neighbourhood, "what the covariances are smoothed over")
        ->check(CLI::IsMember(findParameter(kReferenceSection, "covariance_neighbourhood")->choices));
    command.add_option("--neighbours", options.neighbours, "k of the k nearest")->type_name("K");
    command.add_option("--radius", options.radius_m, "radius of the ball [m]")->type_name("R");
    command.add_option("--sigma", options.sigma_m, "sigma of the Gaussian, w = exp(-r^2 / sigma^2) [m]")
        ->type_name("S");
    command
        .add_option("--smoothing-voxel", options.smoothingVoxelSize_m,
                    "smooth at the means of these voxels only, and take the nearest one's covariance [m]")
        ->type_name("V");
    command
        .add_option("--regularisation", options.regularisation_m2, "added to the diagonal of every covariance [m^2]")
        ->type_name("L");
}

Parameters parametersOf(const ParameterOptions& parameterOptions, const ReferenceOptions& options,
                        std::ostream& remarks) {
    Parameters parameters = unjudgedParametersOf(parameterOptions);
    ReferenceSettings& reference = parameters.reference;
    SmoothingSettings& smoothing = reference.covariance.smoothing;
    if (options.spacing_m) reference.cadSpacing_m = *options.spacing_m;
    if (options.voxelSize_m) reference.voxelSize_m = *options.voxelSize_m;
    if (options.occupancyQuantile) reference.occupancyQuantile = *options.occupancyQuantile;
    setWord("covariance_weights", options.weights, parameters);
    setWord("covariance_neighbourhood", options.neighbourhood, parameters);
    if (options.neighbours) smoothing.neighbours = *options.neighbours;
    if (options.radius_m) smoothing.radius_m = *options.radius_m;
    if (options.sigma_m) smoothing.sigma_m = *options.sigma_m;
    if (options.smoothingVoxelSize_m) reference.covariance.smoothingVoxelSize_m = options.smoothingVoxelSize_m;
    if (options.regularisation_m2) reference.covariance.regularisation_m2 = *options.regularisation_m2;
    requireValid(parameters);
    tellWithoutEffect(options, smoothing, remarks);
    return parameters;
}

}  // namespace fodscope::cli
