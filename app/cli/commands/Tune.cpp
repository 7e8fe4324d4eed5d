// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <optional>
#include <ostream>

#include "app/cli/GridOptions.h"
#include "app/cli/Inputs.h"
#include "app/cli/OutputFile.h"
#include "app/cli/ParameterOptions.h"
#include "app/cli/TrialOptions.h"
#include "app/cli/commands/Commands.h"
#include "core/common/Error.h"
#include "core/common/Files.h"
#include "core/evaluation/CostSurface.h"
#include "core/evaluation/PhotoSearch.h"
#include "core/evaluation/SearchReport.h"
#include "core/evaluation/SearchTrials.h"

namespace fodscope::cli {
namespace {

constexpr const char* kCost = "cost";
constexpr const char* kPhotos = "photos";

struct Options {
    TrialOptions trials;
    ParameterOptions parameters;
    GridOptions grid;
    std::vector<std::string> surfaces;
    std::string objective = kCost;
    std::optional<double> recall;
    std::string worlds;
    int mostCandidates = PhotoSearchSettings().mostCandidates;
    std::string curve;
    std::string out;
};

std::string leftOut(std::size_t nominalMaps) {
    if (nominalMaps == 0) return {};
    return std::to_string(nominalMaps) + (nominalMaps == 1 ? " nominal map was" : " nominal maps were") + " left out.";
}

/// What a search says of itself at the head of the file.
struct Story {
    std::size_t nominalMaps = 0;
    std::map<std::string, std::string> failures;
    /// What a trial that could not be aligned counts.
    std::string failureCounts;
    std::vector<std::string> findings;
    std::vector<std::string> method;
};

/// The whole parameter file, headed by how its best values were found.
std::string tunedYaml(const Options& options, const Parameters& base, const CandidateSettings& best, const Story& story,
                      const SourceFile& reference) {
    std::vector<std::string> lines{"Found by 'fodscope-cli tune' on the trials in " + options.trials.trials + ",",
                                   "with the reference " + options.trials.reference + " (SHA-256 " + reference.sha256 + ")."};
    if (story.nominalMaps > 0) lines.push_back(leftOut(story.nominalMaps));
    for (const auto& [name, why] : story.failures)
        lines.push_back(name + " could not be aligned and " + story.failureCounts + ".");
    lines.insert(lines.end(), story.findings.begin(), story.findings.end());
    lines.insert(lines.end(), story.method.begin(), story.method.end());
    std::string text;
    for (const std::string& line : lines)
        text += "# " + line + "\n";
    Parameters tuned = base;
    tuned.candidates = best;
    return text + "#\n" + parametersYaml(tuned);
}

void tell(const Options& options, const Story& story, Context& context) {
    for (const auto& [name, why] : story.failures)
        context.remarks << "note: " << name << ": " << why << "; it " << story.failureCounts << "\n";
    for (const std::string& line : story.findings)
        context.out << line << "\n";
    if (story.nominalMaps > 0) context.out << leftOut(story.nominalMaps) << "\n";
    context.out << options.out << ": the whole parameter file with these values\n";
}

void writeSurface(const std::string& file, const ParameterSearchResult& result) {
    if (file.ends_with(".png"))
        writeFile(file, costSurfacePng(result));
    else
        writeFile(file, costSurfaceCsv(result));
}

void searchForCost(const Options& options, Context& context) {
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
    const Story story{measured.nominalMaps.size(), measured.failures, "counts 7.5 m at every grid point",
                      searchFindings(result), searchMethod(result)};
    context.progress.report("writing the results", 0.0);
    for (const std::string& surface : options.surfaces)
        writeSurface(surface, result);
    writeFile(options.out, tunedYaml(options, parameters, bestCandidateSettings(result), story, reference.source));
    tell(options, story, context);
}

void requirePhotoOptions(const Options& options) {
    if (options.worlds.empty())
        throw UsageError("--objective photos needs --worlds DIR, the worlds that the candidates are photographed in");
    if (!options.recall)
        throw UsageError("--objective photos needs --recall R, the share of FOD that the photos have to show");
    if (!options.surfaces.empty())
        throw UsageError("--surface shows the costs of --objective cost; --curve FILE.json is what photos come to");
}

void requireCostOptions(const Options& options) {
    if (options.recall || !options.worlds.empty() || !options.curve.empty())
        throw UsageError("--recall, --worlds and --curve go with --objective photos");
}

void searchForPhotos(const Options& options, Context& context) {
    const Parameters parameters = parametersOf(options.parameters);
    PhotoSearchSettings settings;
    settings.recall = *options.recall;
    settings.mostCandidates = options.mostCandidates;
    settings.grid = searchSettingsOver(usualPhotoGrid(parameters.candidates), options.grid);
    requireWritable(options.out);
    if (!options.curve.empty()) requireWritable(options.curve);
    const std::vector<Trial> trials = readTrials(options.trials.trials);
    context.progress.report("reading the reference", 0.0);
    const LoadedReferenceMap reference = loadReference(options.trials.reference);
    Story story;
    const PhotoSearchResult result = namingFiles({{"reference", options.trials.reference}, {"trials", options.trials.trials}}, [&] {
        const PhotoSearchTrials places(reference.reference, trials, options.worlds, parameters,
                                       options.trials.placement(), context.progress);
        story = {places.nominalMaps().size(), places.failures(), "shows no FOD", {}, {}};
        return searchPhotos(places, settings, context.progress);
    });
    story.findings = photoSearchFindings(result);
    story.method = photoSearchMethod(result);
    context.progress.report("writing the results", 0.0);
    if (!options.curve.empty()) writeFile(options.curve, photoSearchJson(result));
    if (!result.best) {
        throw Error(options.trials.trials, story.findings.back().substr(0, story.findings.back().size() - 1),
                    "ask for a lower --recall, or search over a wider grid");
    }
    writeFile(options.out,
              tunedYaml(options, parameters, result.settingsAt(result.best->point), story, reference.source));
    tell(options, story, context);
}

void execute(const Options& options, Context& context) {
    if (options.objective == kPhotos) {
        requirePhotoOptions(options);
        searchForPhotos(options, context);
    } else {
        requireCostOptions(options);
        searchForCost(options, context);
    }
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
    command
        ->add_option("--objective", options->objective,
                     "what is to be least: the paper's cost, or the photos at a wanted recall")
        ->check(CLI::IsMember({kCost, kPhotos}))
        ->capture_default_str();
    command->add_option("--recall", options->recall, "with photos: share of the FOD that they have to show")
        ->check(CLI::Range(0.01, 1.0))
        ->type_name("R");
    command->add_option("--worlds", options->worlds, "with photos: folder with the world NAME.json of each trial")
        ->type_name("DIR");
    command
        ->add_option("--most-candidates", options->mostCandidates,
                     "with photos: leave out grid points with more candidates in a trial")
        ->check(CLI::Range(1, 10000))
        ->capture_default_str();
    command
        ->add_option("--curve", options->curve,
                     "with photos: write the fewest photos at every recall, with their precision")
        ->type_name("FILE.json");
    command->add_option("--out", options->out, "parameter file to write")->required()->type_name("P.yaml");
    command->callback([options, &run] { run = [options](Context& context) { execute(*options, context); }; });
}

}  // namespace fodscope::cli
