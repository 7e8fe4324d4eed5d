// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>
#include <ostream>

#include "app/cli/GridOptions.h"
#include "app/cli/Inputs.h"
#include "app/cli/OutputFile.h"
#include "app/cli/ParameterOptions.h"
#include "app/cli/TrialOptions.h"
#include "app/cli/commands/Commands.h"
#include "core/common/Files.h"
#include "core/evaluation/CostSurface.h"
#include "core/evaluation/SearchReport.h"
#include "core/evaluation/SearchTrials.h"

namespace fodscope::cli {
namespace {

struct Options {
    TrialOptions trials;
    ParameterOptions parameters;
    GridOptions grid;
    std::vector<std::string> surfaces;
    std::string out;
};

std::string leftOut(std::size_t nominalMaps) {
    if (nominalMaps == 0) return {};
    return std::to_string(nominalMaps) + (nominalMaps == 1 ? " nominal map was" : " nominal maps were") + " left out.";
}

/// The whole parameter file, headed by how its best values were found.
std::string tunedYaml(const Options& options, const Parameters& base, const ParameterSearchResult& result,
                      const MeasuredTrials& measured, const SourceFile& reference) {
    std::vector<std::string> lines{"Found by 'fodscope-cli tune' on the trials in " + options.trials.trials + ",",
                                   "with the reference " + options.trials.reference + " (SHA-256 " + reference.sha256 + ")."};
    if (!measured.nominalMaps.empty()) lines.push_back(leftOut(measured.nominalMaps.size()));
    for (const auto& [name, why] : measured.failures)
        lines.push_back(name + " could not be aligned and counts 7.5 m everywhere.");
    for (const std::string& line : searchFindings(result))
        lines.push_back(line);
    for (const std::string& line : searchMethod(result))
        lines.push_back(line);
    std::string text;
    for (const std::string& line : lines)
        text += "# " + line + "\n";
    Parameters tuned = base;
    tuned.candidates = bestCandidateSettings(result);
    return text + "#\n" + parametersYaml(tuned);
}

void writeSurface(const std::string& file, const ParameterSearchResult& result) {
    if (file.ends_with(".png"))
        writeFile(file, costSurfacePng(result));
    else
        writeFile(file, costSurfaceCsv(result));
}

void execute(const Options& options, Context& context) {
    const Parameters parameters = parametersOf(options.parameters);
    const ParameterSearchSettings settings = searchSettingsOf(options.grid, parameters.candidates);
    requireWritable(options.out);
    for (const std::string& surface : options.surfaces)
        requireWritable(surface);
    const std::vector<Trial> trials = readTrials(options.trials.trials);
    context.progress.report("reading the reference", 0.0);
    const LoadedReferenceMap reference = loadReference(options.trials.reference);
    const auto [measured, result] = namingFiles({{"reference", options.trials.reference}, {"trials", options.trials.trials}}, [&] {
        MeasuredTrials maps = measureTrials(reference.reference, trials, parameters, options.trials.placement(), context.progress);
        ParameterSearchResult found = searchParameters(maps.trials, settings, context.progress);
        return std::pair(std::move(maps), std::move(found));
    });
    const std::string yaml = tunedYaml(options, parameters, result, measured, reference.source);
    context.progress.report("writing the results", 0.0);
    for (const std::string& surface : options.surfaces)
        writeSurface(surface, result);
    writeFile(options.out, yaml);
    for (const auto& [name, why] : measured.failures)
        context.remarks << "note: " << name << ": " << why << "; it counts 7.5 m at every grid point\n";
    for (const std::string& line : searchFindings(result))
        context.out << line << "\n";
    if (!measured.nominalMaps.empty()) context.out << leftOut(measured.nominalMaps.size()) << "\n";
    context.out << options.out << ": the whole parameter file with these values\n";
}

}  // namespace

void addTuneCommand(CLI::App& program, Run& run) {
    const auto options = std::make_shared<Options>();
    CLI::App* command =
        program.add_subcommand("tune", "search the best threshold, cluster cutoff and least points on trials");
    addTrialOptions(*command, options->trials);
    addMethodOptions(*command, options->parameters);
    addGridOptions(*command, options->grid);
    command
        ->add_option(
            "--surface", options->surfaces,
            "write the costs too: every grid point (FILE.csv), or a picture at the best least points (FILE.png)")
        ->check([](const std::string& file) {
            return file.ends_with(".csv") || file.ends_with(".png") ? "" : file + " is neither .csv nor .png";
        })
        ->type_name("FILE");
    command->add_option("--out", options->out, "parameter file to write")->required()->type_name("P.yaml");
    command->callback([options, &run] { run = [options](Context& context) { execute(*options, context); }; });
}

}  // namespace fodscope::cli
