// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>
#include <ostream>

#include "app/cli/Inputs.h"
#include "app/cli/OutputFile.h"
#include "app/cli/ParameterOptions.h"
#include "app/cli/TrialOptions.h"
#include "app/cli/commands/Commands.h"
#include "core/common/Files.h"
#include "core/evaluation/EvaluationReport.h"
#include "core/evaluation/PhotoEvaluation.h"

namespace fodscope::cli {
namespace {

struct Options {
    TrialOptions trials;
    ParameterOptions parameters;
    double lambda = kUnassociatedWeight_m;
    bool photos = false;
    std::string worlds;
    std::string out;
};

void execute(const Options& options, Context& context) {
    if (options.photos && options.worlds.empty())
        throw UsageError("--photos needs --worlds DIR, the worlds that the candidates are photographed in");
    EvaluationSettings settings;
    settings.parameters = parametersOf(options.parameters);
    settings.lambda = options.lambda;
    settings.placement = options.trials.placement();
    requireWritable(options.out);
    const std::vector<Trial> trials = readTrials(options.trials.trials);
    context.progress.report("reading the reference", 0.0);
    const LoadedReferenceMap reference = loadReference(options.trials.reference);
    PhotoTaker takePhotos;
    if (options.photos) takePhotos = makePhotoTaker(options.worlds, trials, reference.reference, settings.parameters);
    const Evaluation evaluation = namingFiles({{"reference", options.trials.reference}, {"trials", options.trials.trials}}, [&] {
        return evaluateTrials(reference.reference, trials, settings, takePhotos, context.progress);
    });
    writeFile(options.out, evaluationJson(evaluation, reference.source));
    context.out << evaluationText(evaluation);
}

}  // namespace

void addEvaluateCommand(CLI::App& program, Run& run) {
    const auto options = std::make_shared<Options>();
    CLI::App* command =
        program.add_subcommand("evaluate", "run the detection on trials with known FOD and count what it found");
    addTrialOptions(*command, options->trials);
    addDetectionParameterOptions(*command, options->parameters);
    command->add_option("--lambda", options->lambda, "cost of an unassociated candidate [m]")
        ->check(CLI::Range(0.0, 1000.0))
        ->capture_default_str();
    command->add_flag("--photos", options->photos, "have the simulated robot photograph every candidate");
    command->add_option("--worlds", options->worlds, "folder with the world NAME.json of each trial")->type_name("DIR");
    command->add_option("--out", options->out, "file to write to")->required()->type_name("evaluation.json");
    command->callback([options, &run] { run = [options](Context& context) { execute(*options, context); }; });
}

}  // namespace fodscope::cli
