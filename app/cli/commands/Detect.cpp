// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/cli/DetectionRun.h"
#include "app/cli/OutputFolder.h"
#include "app/cli/commands/Commands.h"
#include "core/common/Files.h"
#include "core/detection/DiscrepancyPly.h"
#include "core/inspection/Inspection.h"

namespace fodscope::cli {
namespace {

struct Options {
    DetectionOptions detection;
    std::string out;
};

DetectionRecord recordOf(const DetectionRun& run) {
    DetectionRecord record;
    record.parameters = run.parameters;
    record.registration = run.result.registration;
    record.floorHeight_m = run.result.floorHeight_m;
    record.field = run.result.field;
    record.candidates = run.result.candidates;
    record.coverage = run.result.coverage;
    return record;
}

std::string timingJson(const DetectionRun& run) {
    nlohmann::ordered_json seconds = {{"load", run.loadSeconds}};
    double total_s = run.loadSeconds;
    for (const char* stage : {"denoise", "registration", "discrepancy", "chi_square", "candidates", "coverage"}) {
        const auto found = run.result.stageSeconds.find(stage);
        if (found == run.result.stageSeconds.end()) continue;
        seconds[stage] = found->second;
        total_s += found->second;
    }
    const nlohmann::ordered_json root = {
        {"schema", "fodscope.timing/1"}, {"seconds", seconds}, {"total_seconds", total_s}};
    return root.dump(2) + "\n";
}

void execute(const Options& options, Context& context) {
    const OutputFolder folder(options.out);
    const DetectionRun run = runDetection(options.detection, context);
    const DetectionRecord record = recordOf(run);
    context.progress.report("writing the results", 0.0);
    writeDiscrepancyPly(folder.path() / "discrepancy.ply", *record.field, *record.candidates,
                        record.parameters.candidates.metric);
    writeFile(folder.path() / "timing.json", timingJson(run));
    writeFile(folder.path() / "candidates.json", candidatesJson(run.reference.source, run.map.source, record));
    context.out << (folder.path() / "candidates.json").string() << ": " << record.candidates->candidates.size()
                << " candidates (" << record.registration.summary << ")\n";
}

}  // namespace

void addDetectCommand(CLI::App& program, Run& run) {
    const auto options = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("detect", "compare a map with a reference map and list the candidates");
    addDetectionOptions(*command, options->detection);
    command->add_option("--out", options->out, "folder for candidates.json, discrepancy.ply and timing.json")
        ->required()
        ->type_name("DIR");
    command->callback([options, &run] { run = [options](Context& context) { execute(*options, context); }; });
}

}  // namespace fodscope::cli
