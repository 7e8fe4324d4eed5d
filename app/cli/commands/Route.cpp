// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <ostream>

#include "app/cli/NewSession.h"
#include "app/cli/ParameterOptions.h"
#include "app/cli/commands/Commands.h"
#include "core/cloud/PointCloudIo.h"
#include "core/common/Error.h"
#include "core/common/Hash.h"
#include "core/inspection/AutomaticInspection.h"
#include "core/simulation/BuiltinTank.h"
#include "core/simulation/FloorGrid.h"
#include "core/simulation/SimulatedRobot.h"

namespace fodscope::cli {
namespace {

struct Options {
    std::string poses;
    std::string robot;
    std::string world;
    unsigned seed = 1;
    ParameterOptions parameters;
    std::string session;
    std::string out;
};

std::shared_ptr<const World> worldFor(const Options& options) {
    if (options.world != "builtin") return std::make_shared<const World>(readWorld(options.world));
    auto world = std::make_shared<World>(builtinWorld({}));
    placeFod(*world, options.seed);
    return world;
}

std::unique_ptr<RobotLink> robotFor(const std::shared_ptr<const World>& world, const Options& options,
                                    const Parameters& parameters, Context& context) {
    SimulatedRobotSettings settings;
    settings.waitForRendering = true;
    settings.isWaitOver = [&context] { return context.progress.isCancelled(); };
    settings.mapping.emplace();
    settings.mapping->seed = options.seed;
    return makeSimulatedRobot(world, exploredFloor(*world), nullptr, parameters.costMap, settings);
}

std::size_t countOf(const std::vector<Visit>& visits, VisitState state) {
    return static_cast<std::size_t>(std::ranges::count(visits, state, &Visit::state));
}

/// What was driven stays on record, whatever comes after it; a session in which nothing was driven does not.
void driveAndKeep(NewSession& session, Inspection& inspection, RobotLink& robot, Progress& progress) {
    try {
        driveRoute(robot, inspection, progress);
    } catch (...) {
        if (std::ranges::any_of(inspection.state().routeVisits, [](const Visit& visit) { return visit.tries > 0; }))
            session.keep();
        throw;
    }
    session.keep();
}

void execute(const Options& options, Context& context) {
    requireNoSession(options.session);
    const Parameters parameters = parametersOf(options.parameters);
    const InspectionRoute route = readRoute(options.poses);
    context.progress.report("reading the world", 0.0);
    const std::shared_ptr<const World> world = worldFor(options);
    const std::unique_ptr<RobotLink> robot = robotFor(world, options, parameters, context);

    InspectionHeader header = newInspectionHeader();
    header.title = std::filesystem::path(options.poses).filename().string();
    header.robot = robot->name();
    NewSession session(options.session, header);
    InspectionState state;
    state.header = header;
    Inspection inspection(std::move(state), session.file());
    inspection.setParameters(parameters);
    inspection.setRoute(route);
    driveAndKeep(session, inspection, *robot, context.progress);

    const std::shared_ptr<const PointCloud> map = fetchMap(*robot, context.progress);
    writePointCloud(options.out, *map);
    inspection.setMap({options.out, sha256OfFile(options.out), map->size()});
    const std::vector<Visit>& visits = inspection.state().routeVisits;
    context.out << options.session << ": " << countOf(visits, VisitState::Done) << " of " << visits.size()
                << " poses driven, " << inspection.state().photos.size() << " photos\n"
                << options.out << ": " << map->size() << " points\n";
    for (const Visit& visit : visits) {
        if (visit.state != VisitState::Done)
            context.out << visit.waypointId << ": " << toString(visit.state) << ", " << reasonText(visit) << "\n";
    }
}

}  // namespace

void addRouteCommand(CLI::App& program, Run& run) {
    const auto options = std::make_shared<Options>();
    CLI::App* command =
        program.add_subcommand("route", "drive an inspection route while the robot maps, and fetch the map");
    command->add_option("--poses", options->poses, "the route")->required()->type_name("ROUTE.yaml");
    command->add_option("--robot", options->robot, "who drives and maps")
        ->required()
        ->check(CLI::IsMember({"simulated"}));
    command->add_option("--world", options->world, "what the simulated robot stands in")
        ->required()
        ->type_name("builtin|WORLD.json");
    command->add_option("--seed", options->seed, "of the simulated map, and of what lies in the built-in tank")
        ->type_name("S");
    addPresetOptions(*command, options->parameters);
    command->add_option("--session", options->session, "session file to make")->required()->type_name("OUT.fodscope");
    command->add_option("--out", options->out, "the map to write")->required()->type_name("MAP.pcd");
    command->callback([options, &run] { run = [options](Context& context) { execute(*options, context); }; });
}

}  // namespace fodscope::cli
