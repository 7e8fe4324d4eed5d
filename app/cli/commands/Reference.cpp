// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>
#include <ostream>

#include "app/cli/Inputs.h"
#include "app/cli/ParameterOptions.h"
#include "app/cli/commands/Commands.h"
#include "core/inspection/ReferenceFiles.h"
#include "core/reference/ReferenceMapIo.h"

namespace fodscope::cli {
namespace {

struct Options {
    std::string cad;
    double scale = 1.0;
    CadReferenceSettings cadSettings;
    std::vector<std::string> maps;
    std::string alignTo;
    std::string transforms;
    MeanReferenceSettings mean;
    ParameterOptions parameters;
    std::string out;
};

ReferenceMap fromMaps(const Options& options, Context& context) {
    const Parameters parameters = parametersOf(options.parameters);
    NominalMapsRequest request;
    request.maps.assign(options.maps.begin(), options.maps.end());
    if (!options.alignTo.empty()) request.alignTo = options.alignTo;
    request.meshScale = options.scale;
    if (!options.transforms.empty()) request.given_T_reference_from_map = readTransforms(options.transforms);
    request.mean = options.mean;
    request.mean.denoise = parameters.denoise;
    request.registration = parameters.registration;
    return namingFiles({{"transforms", options.transforms}},
                       [&] { return referenceFromMapFiles(request, context.progress); });
}

void execute(const Options& options, Context& context) {
    const ReferenceMap reference =
        options.cad.empty() ? fromMaps(options, context)
                            : referenceFromMeshFile(options.cad, options.scale, options.cadSettings, context.progress);
    context.progress.report("writing the reference", 0.0);
    writeReferenceMap(options.out, reference);
    context.out << options.out << ": " << reference.size() << " points, "
                << (reference.hasCovariance() ? "with" : "without") << " covariances\n";
}

}  // namespace

void addReferenceCommand(CLI::App& program, Run& run) {
    const auto options = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("reference", "make a reference map from a CAD mesh or nominal maps");
    CLI::Option_group* source = command->add_option_group("source", "what it is made from");
    CLI::Option* cad = source->add_option("--cad", options->cad, "CAD mesh (STL, PLY or OBJ)")->type_name("MESH");
    CLI::Option* maps = source->add_option("--maps", options->maps, "nominal maps (PCD or PLY)")->type_name("MAP...");
    source->require_option(1);
    command->add_option("--scale", options->scale, "metres in one unit of the mesh")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command->add_option("--spacing", options->cadSettings.spacing_m, "area / spacing^2 samples of the mesh [m]")
        ->check(CLI::PositiveNumber)
        ->needs(cad)
        ->capture_default_str();
    CLI::Option* alignTo =
        command->add_option("--align-to", options->alignTo, "mesh or map into whose frame the maps are moved")
            ->type_name("MESH_OR_MAP")
            ->needs(maps);
    command->add_option("--transforms", options->transforms, "reference from map of each map (m00..m33)")
        ->type_name("T.csv")
        ->needs(maps)
        ->excludes(alignTo);
    command->add_option("--voxel", options->mean.voxelSize_m, "voxels of the mean [m]")
        ->check(CLI::PositiveNumber)
        ->needs(maps)
        ->capture_default_str();
    command->add_option("--occupancy-quantile", options->mean.occupancyQuantile, "emptier voxels are dropped")
        ->check(CLI::Range(0.0, 1.0))
        ->needs(maps)
        ->capture_default_str();
    command->add_option("--neighbours", options->mean.covarianceNeighbours, "k of the covariance smoothing")
        ->check(CLI::Range(1, 1000000))
        ->needs(maps)
        ->capture_default_str();
    addPresetOptions(*command, options->parameters);
    command->add_option("--out", options->out, "reference map to write")->required()->type_name("REF.ply");
    command->callback([options, &run] { run = [options](Context& context) { execute(*options, context); }; });
}

}  // namespace fodscope::cli
