// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/cli/DetectionRun.h"
#include "app/cli/OutputFolder.h"
#include "app/cli/commands/Commands.h"
#include "core/common/Files.h"
#include "core/detection/DiscrepancyPly.h"
#include "core/inspection/Inspection.h"
#include "core/registration/RegistrationSummary.h"

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

/// The form that --initial takes.
std::string transformCsv(const Transform& transform) {
    std::string csv;
    const std::array<double, 16> rows = rowsFromTransform(transform);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        char number[32];
        std::snprintf(number, sizeof number, "%.12g", rows[i]);
        csv += number;
        csv += i % 4 == 3 ? "\n" : ",";
    }
    return csv;
}

/// Nobody but the operator can tell which pose is true: each is left as a file to start from, and no candidates.
void writePoses(const DetectionRun& run, const DetectionRecord& record, const std::filesystem::path& folder,
                Context& context) {
    const RegistrationResult& registration = record.registration;
    std::vector<Transform> poses{registration.T_reference_from_map};
    for (const PoseAlternative& other : registration.alternatives)
        poses.push_back(other.T_reference_from_map);
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const std::filesystem::path file = folder / ("pose_" + std::to_string(i + 1) + ".csv");
        writeFile(file, transformCsv(poses[i]));
        context.remarks << "warning: " << file.string() << ": " << poseInWords(poses[i])
                        << "; start from it with --initial\n";
    }
    writeFile(folder / "candidates.json", candidatesJson(run.reference.source, run.map.source, record));
}

void execute(const Options& options, Context& context) {
    const OutputFolder folder(options.out);
    const DetectionRun run = runDetection(options.detection, context, AfterDetection::DropMap);
    const DetectionRecord record = recordOf(run);
    if (record.registration.quality == RegistrationQuality::Ambiguous) writePoses(run, record, folder.path(), context);
    requireTrustedAlignment(run, options.detection.map);
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
