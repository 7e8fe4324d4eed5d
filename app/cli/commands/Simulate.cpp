// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>
#include <ostream>

#include "app/cli/OutputFolder.h"
#include "app/cli/StagingFolder.h"
#include "app/cli/commands/Commands.h"
#include "core/simulation/BuiltinDemo.h"
#include "core/simulation/Trials.h"

namespace fodscope::cli {
namespace {

struct Options {
    std::string world;
    std::string kind;
    bool quick = false;
    TrialSeriesSettings series;
    std::string out;
};

void execute(const Options& options, Context& context) {
    TrialSeriesSettings series = options.series;
    if (options.world != "builtin") series.worldFile = options.world;
    series.kind = options.kind == "nominal" ? TrialKind::Nominal : TrialKind::Trial;
    if (options.quick) series.mapping = quickMapping();
    const OutputFolder folder(options.out);
    StagingFolder staging(folder.path());
    const std::vector<std::string> names = simulateTrials(staging.path(), series, context.progress);
    staging.publish();
    for (const std::string& name : names)
        context.out << (folder.path() / (name + ".pcd")).string() << "\n";
}

}  // namespace

void addSimulateCommand(CLI::App& program, Run& run) {
    const auto options = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("simulate", "map a simulated tank, empty or with FOD placed in it");
    command->add_option("--world", options->world, "'builtin' or a world file")
        ->required()
        ->type_name("builtin|WORLD.json");
    command->add_option("--kind", options->kind, "nominal: without FOD; trial: with FOD placed anew in each")
        ->required()
        ->check(CLI::IsMember({"nominal", "trial"}));
    command->add_option("--count", options->series.count, "how many")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_option("--seed", options->series.seed, "of the first; each next takes one more")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    const std::string quick = "smaller depth images: coarser maps in a fraction of the time";
    command->add_flag("--quick", options->quick, quick);
    command->add_option("--out", options->out, "folder to write to")->required()->type_name("DIR");
    command->callback([options, &run] { run = [options](Context& context) { execute(*options, context); }; });
}

}  // namespace fodscope::cli
