// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>
#include <ostream>

#include "app/cli/DetectionRun.h"
#include "app/cli/LabelsFile.h"
#include "app/cli/NewSession.h"
#include "app/cli/commands/Commands.h"
#include "app/resources/ResourceFolder.h"
#include "core/common/Error.h"
#include "core/inspection/AutomaticInspection.h"
#include "core/simulation/SimulatedRobot.h"

namespace fodscope::cli {
namespace {

struct Options {
    DetectionOptions detection;
    std::string robot;
    std::string world;
    std::string grid;
    std::string labels;
    std::string labelSet;
    InspectionHeader header;
    std::string session;
};

/// The world that a map was simulated in lies beside it, see `simulate`.
std::filesystem::path worldFileFor(const Options& options) {
    if (options.world != "builtin") return options.world;
    const std::filesystem::path map = options.detection.map;
    const std::filesystem::path file = map.parent_path() / "worlds" / (map.stem().string() + ".json");
    if (!std::filesystem::exists(file)) {
        throw Error(file.string(), "the world that this map was simulated in is not there",
                    "make the map with 'fodscope-cli simulate --world builtin', or give --world WORLD.json");
    }
    return file;
}

AutomaticLabeller labellerFor(const Options& options, const std::shared_ptr<const World>& world,
                              const LabelSet& labelSet, const DetectionRecord& detection) {
    if (options.labels.empty()) {
        const auto truth = std::make_shared<GroundTruthLabeller>(world, options.world == "builtin");
        return {truth->name(), [truth, labelSet](const Photo& photo) { return truth->answer(photo, labelSet); }};
    }
    const auto answers = readLabels(options.labels, labelSet);
    requireKnownCandidates(answers, *detection.candidates, options.labels);
    return {std::filesystem::path(options.labels).filename().string(),
            [answers, detection](const Photo& photo) { return answerFor(photo, answers, detection); }};
}

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

OccupancyGrid gridFor(const Options& options, const DetectionRun& run) {
    if (!options.grid.empty()) return readMapServerGrid(options.grid);
    return occupancyFromMap(run.result.denoisedMap->points, run.result.registration.T_reference_from_map,
                            run.result.floorHeight_m, run.parameters.occupancy);
}

AutomaticInspectionInput inputOf(const DetectionRun& run, const World& world, OccupancyGrid grid_map,
                                 LabelSet labelSet) {
    AutomaticInspectionInput input;
    input.referenceSource = run.reference.source;
    input.reference = run.reference.reference;
    input.mapSource = run.map.source;
    input.parameters = run.parameters;
    input.detection = run.result;
    input.grid_map = std::move(grid_map);
    input.robotStart_map = poseFromTransform(world.T_map_from_world * transformFromPose(world.robotStart_world));
    input.labelSet = std::move(labelSet);
    return input;
}

void tell(const InspectionState& state, const std::string& session, Context& context) {
    std::map<Verdict, int> counts;
    for (const CandidateVerdict& verdict : verdictsOf(state))
        ++counts[verdict.verdict];
    const std::size_t candidates = state.detection->candidates->candidates.size();
    context.out << session << ": " << candidates << " candidates, " << state.photos.size() << " photos";
    for (const auto& [verdict, count] : counts)
        context.out << ", " << count << " " << toString(verdict);
    context.out << "\n";
}

void execute(const Options& options, Context& context) {
    requireNoSession(options.session);
    context.progress.report("reading the world", 0.0);
    const auto world = std::make_shared<const World>(readWorld(worldFileFor(options)));
    const std::filesystem::path usualLabels = resourceFolder() / "labels" / "default.yaml";
    const LabelSet labelSet =
        readLabelSet(options.labelSet.empty() ? usualLabels : std::filesystem::path(options.labelSet));
    const DetectionRun run = runDetection(options.detection, context, AfterDetection::KeepMap);
    requireTrustedAlignment(run, options.detection.map);
    const OccupancyGrid grid_map = gridFor(options, run);
    const AutomaticLabeller labeller = labellerFor(options, world, labelSet, recordOf(run));
    SimulatedRobotSettings robotSettings = robotWith(run.parameters.camera);
    robotSettings.waitForRendering = true;
    robotSettings.isWaitOver = [&context] { return context.progress.isCancelled(); };
    const std::unique_ptr<RobotLink> robot =
        makeSimulatedRobot(world, grid_map, run.map.cloud, run.parameters.costMap, robotSettings);

    InspectionHeader header = newInspectionHeader();
    header.title = options.header.title;
    header.ship = options.header.ship;
    header.tank = options.header.tank;
    header.workOrder = options.header.workOrder;
    header.inspector = options.header.inspector;
    header.robot = robot->name();
    NewSession session(options.session, header);
    InspectionState state;
    state.header = header;
    Inspection inspection(std::move(state), session.file());
    inspectAutomatically(inputOf(run, *world, grid_map, labelSet), *robot, labeller, inspection, context.progress);
    session.keep();
    tell(inspection.state(), options.session, context);
}

}  // namespace

void addInspectCommand(CLI::App& program, Run& run) {
    const auto options = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("inspect", "carry a whole inspection out, without a window");
    addDetectionOptions(*command, options->detection);
    command->add_option("--robot", options->robot, "who drives and takes the photos")
        ->required()
        ->check(CLI::IsMember({"simulated"}));
    command->add_option("--world", options->world, "what the simulated robot stands in")
        ->required()
        ->type_name("builtin|WORLD.json");
    command->add_option("--grid", options->grid, "grid of ROS map_server, map frame; else one is made from the map")
        ->type_name("MAP.yaml");
    command->add_option("--labels", options->labels, "candidate,label[,comment]; else the world's truth is used")
        ->type_name("FILE.csv");
    command->add_option("--label-set", options->labelSet, "labels that can be given (YAML)")->type_name("FILE");
    command->add_option("--title", options->header.title, "title of the inspection");
    command->add_option("--ship", options->header.ship, "for the record");
    command->add_option("--tank", options->header.tank, "for the record");
    command->add_option("--work-order", options->header.workOrder, "for the record");
    command->add_option("--inspector", options->header.inspector, "for the record");
    command->add_option("--session", options->session, "session file to make")->required()->type_name("OUT.fodscope");
    command->callback([options, &run] { run = [options](Context& context) { execute(*options, context); }; });
}

}  // namespace fodscope::cli
