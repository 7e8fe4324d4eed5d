// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "app/cli/ParameterOptions.h"

namespace CLI {
class App;
}

namespace fodscope::cli {

/// The options of how a reference is made, over the section "reference" of the parameters.
struct ReferenceOptions {
    std::optional<double> spacing_m;
    std::optional<double> voxelSize_m;
    std::optional<double> occupancyQuantile;
    std::optional<std::string> weights;
    std::optional<std::string> neighbourhood;
    std::optional<int> neighbours;
    std::optional<double> radius_m;
    std::optional<double> sigma_m;
    std::optional<double> smoothingVoxelSize_m;
    std::optional<double> regularisation_m2;
};

/// --spacing, --voxel, --occupancy-quantile, --weights, --neighbourhood, --neighbours, --radius, --sigma,
/// --smoothing-voxel, --regularisation
void addReferenceOptions(CLI::App& command, ReferenceOptions& options);

/// @return the parameters with the options laid over them
/// @param remarks told about options that the others leave without effect
/// @throws Error for the parameter file; UsageError that lists all options out of range
Parameters parametersOf(const ParameterOptions& parameters, const ReferenceOptions& options, std::ostream& remarks);

}  // namespace fodscope::cli
