// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <ostream>

#include "app/cli/CandidatesFile.h"
#include "app/cli/Inputs.h"
#include "app/cli/ParameterOptions.h"
#include "app/cli/commands/Commands.h"
#include "core/common/Error.h"
#include "core/common/Files.h"

namespace fodscope::cli {
namespace {

struct Options {
    std::string candidates;
    std::string grid;
    std::string map;
    std::string robot;
    ParameterOptions parameters;
    std::string out;
};

OccupancyGrid gridFor(const Options& options, const CandidatesFile& candidates, const Parameters& parameters,
                      Context& context) {
    if (!options.grid.empty()) return readMapServerGrid(options.grid);
    const LoadedMap map = loadMap(options.map, context);
    keepOnly(*map.cloud, keptByOutlierRemoval(map.cloud->points, parameters.denoise, context.progress));
    return namingFiles({{"map", options.map}}, [&] {
        return occupancyFromMap(map.cloud->points, candidates.T_reference_from_map, *candidates.floorHeight_m,
                                parameters.occupancy);
    });
}

VisitPlan planFor(const Options& options, CandidatesFile& candidates, const Pose2& robot_map, Context& context) {
    const Parameters parameters = parametersOf(options.parameters);
    const OccupancyGrid grid = gridFor(options, candidates, parameters, context);
    CostMap collision = inflate(grid, parameters.costMap);
    floodFill(collision, robot_map);
    const std::vector<Eigen::Vector3d> discrepant_map = addVoxels(candidates, options.candidates);
    const CostMap sight = inflate(withoutCandidates(grid, discrepant_map), parameters.costMap);
    return planVisits(candidates.targets, collision, sight, robot_map, parameters.waypoints, parameters.camera,
                      context.progress);
}

void tell(const VisitPlan& plan, const std::string& file, Context& context) {
    const auto photos = std::ranges::count_if(plan.waypoints, [](const Waypoint& w) { return w.pose_map.has_value(); });
    context.out << file << ": " << photos << " waypoints for " << plan.views.size() << " candidates, " << plan.length_m
                << " m\n";
    if (plan.nearestNextLength_m && plan.shortestTourLength_m)
        context.out << "nearest next: " << *plan.nearestNextLength_m
                    << " m, shortest tour: " << *plan.shortestTourLength_m << " m\n";
    for (const CandidateView& view : plan.views) {
        if (view.rest == WaypointStatus::Ok) continue;
        context.out << view.candidateId << ": "
                    << (view.share > 0.0 ? "a part of it has no waypoint: " : "no waypoint: ") << toString(view.rest)
                    << "\n";
    }
}

void execute(const Options& options, Context& context) {
    const Pose2 robot_map = parsePose(options.robot);
    CandidatesFile candidates = readCandidatesFile(options.candidates);
    VisitPlan plan;
    plan.start_map = robot_map;
    if (!candidates.targets.empty()) plan = planFor(options, candidates, robot_map, context);
    writeFile(options.out, waypointsJson(plan));
    tell(plan, options.out, context);
}

}  // namespace

void addPlanCommand(CLI::App& program, Run& run) {
    const auto options = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("plan", "find a pose to photograph each candidate from");
    command->add_option("--candidates", options->candidates, "candidates.json of detect")
        ->required()
        ->type_name("FILE");
    CLI::Option_group* floor = command->add_option_group("floor", "where the robot can drive");
    floor->add_option("--grid", options->grid, "grid of ROS map_server, map frame")->type_name("MAP.yaml");
    floor->add_option("--map", options->map, "the map, from which a grid is made")->type_name("MAP");
    floor->require_option(1);
    command->add_option("--robot", options->robot, "where the robot is, map frame")
        ->required()
        ->type_name("X,Y,YAW_DEG");
    addPresetOptions(*command, options->parameters);
    command->add_option("--out", options->out, "waypoints.json to write")->required()->type_name("FILE");
    command->callback([options, &run] { run = [options](Context& context) { execute(*options, context); }; });
}

}  // namespace fodscope::cli
