// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <ostream>

#include "app/cli/Inputs.h"
#include "app/cli/ReferenceOptions.h"
#include "app/cli/commands/Commands.h"
#include "core/inspection/ReferenceFiles.h"
#include "core/reference/ReferenceMapIo.h"

namespace fodscope::cli {
namespace {

struct Options {
    std::string cad;
    double scale = 1.0;
    std::vector<std::string> covarianceMaps;
    std::vector<std::string> maps;
    std::string alignTo;
    std::string transforms;
    std::string initial;
    ReferenceOptions reference;
    ParameterOptions parameters;
    std::string out;
};

NominalMapsRequest requestOf(const Options& options, const std::vector<std::string>& maps,
                             const Parameters& parameters) {
    NominalMapsRequest request;
    request.maps.assign(maps.begin(), maps.end());
    if (!options.alignTo.empty()) request.alignTo = options.alignTo;
    request.meshScale = options.scale;
    if (!options.transforms.empty()) request.given_T_reference_from_map = readTransforms(options.transforms);
    if (!options.initial.empty()) request.start_T_reference_from_map = readTransforms(options.initial);
    request.mean = meanReferenceSettings(parameters);
    request.registration = parameters.registration;
    return request;
}

ReferenceMap make(const Options& options, const Parameters& parameters, Progress& progress) {
    if (options.cad.empty()) return referenceFromMapFiles(requestOf(options, options.maps, parameters), progress);
    const CadReferenceSettings cad{.spacing_m = parameters.reference.cadSpacing_m};
    if (options.covarianceMaps.empty()) return referenceFromMeshFile(options.cad, options.scale, cad, progress);
    return referenceFromMeshAndMapFiles(options.cad, cad, requestOf(options, options.covarianceMaps, parameters),
                                        progress);
}

void execute(const Options& options, Context& context) {
    const Parameters parameters = parametersOf(options.parameters, options.reference, context.remarks);
    const ReferenceMap reference = namingFiles({{"transforms", options.transforms}, {"start poses", options.initial}},
                                               [&] { return make(options, parameters, context.progress); });
    context.progress.report("writing the reference", 0.0);
    writeReferenceMap(options.out, reference);
    const auto untrained = std::count(reference.untrained.begin(), reference.untrained.end(), std::uint8_t{1});
    context.out << options.out << ": " << reference.size() << " points, "
                << (reference.hasCovariance() ? "with" : "without") << " covariances";
    if (untrained > 0) context.out << ", " << untrained << " of them untrained";
    context.out << "\n";
}

/// Options that say how something is made are refused where that is not made.
void needEach(CLI::App& command, const std::vector<std::string>& names, CLI::Option* needed) {
    for (const std::string& name : names)
        command.get_option(name)->needs(needed);
}

}  // namespace

void addReferenceCommand(CLI::App& program, Run& run) {
    const auto options = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("reference", "make a reference map from a CAD mesh or nominal maps");
    CLI::Option_group* source = command->add_option_group("source", "what it is made from");
    CLI::Option* cad = source->add_option("--cad", options->cad, "CAD mesh (STL, PLY or OBJ)")->type_name("MESH");
    CLI::Option* maps = source->add_option("--maps", options->maps, "nominal maps (PCD or PLY)")->type_name("MAP...");
    source->require_option(1);
    CLI::Option* covarianceMaps =
        command->add_option("--covariance-maps", options->covarianceMaps, "nominal maps that give a mesh covariances")
            ->type_name("MAP...")
            ->needs(cad);
    command->add_option("--scale", options->scale, "metres in one unit of the mesh")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    CLI::Option* alignTo =
        command->add_option("--align-to", options->alignTo, "mesh or map into whose frame the maps are moved")
            ->type_name("MESH_OR_MAP")
            ->needs(maps);
    CLI::Option* transforms =
        command->add_option("--transforms", options->transforms, "reference from map of each map (m00..m33)")
            ->type_name("T.csv")
            ->excludes(alignTo);
    command->add_option("--initial", options->initial, "known start of each map's registration (m00..m33)")
        ->type_name("T.csv")
        ->excludes(transforms);
    addReferenceOptions(*command, options->reference);
    needEach(*command, {"--spacing"}, cad);
    needEach(*command, {"--voxel", "--occupancy-quantile"}, maps);
    addPresetOptions(*command, options->parameters);
    command->add_option("--out", options->out, "reference map to write")->required()->type_name("REF.ply");
    command->callback([=, &run] {
        const std::vector<std::string> ofMaps{"--transforms",    "--initial",         "--weights",
                                              "--neighbourhood", "--neighbours",      "--radius",
                                              "--sigma",         "--smoothing-voxel", "--regularisation"};
        for (const std::string& name : ofMaps) {
            if (command->count(name) > 0 && maps->count() == 0 && covarianceMaps->count() == 0)
                throw CLI::RequiresError(name, "--maps or --covariance-maps");
        }
        run = [options](Context& context) { execute(*options, context); };
    });
}

}  // namespace fodscope::cli
