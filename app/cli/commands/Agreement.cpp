// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>
#include <ostream>

#include "app/cli/OutputFile.h"
#include "app/cli/commands/Commands.h"
#include "core/common/Error.h"
#include "core/common/Files.h"
#include "core/evaluation/PhotoTruth.h"
#include "storage/SessionFile.h"

namespace fodscope::cli {
namespace {

struct Options {
    std::vector<std::string> sessions;
    std::string worlds;
    std::string out;
};

/// The world has the name of the map that was inspected.
std::filesystem::path worldFileFor(const std::string& worlds, const std::string& session,
                                   const InspectionState& state) {
    if (!state.mapSource)
        throw Error(session, "has no map, so that its world is not known", "leave this session or --worlds out");
    const std::filesystem::path name = std::filesystem::path(state.mapSource->path).stem();
    const std::filesystem::path file = std::filesystem::path(worlds) / (name.string() + ".json");
    if (!std::filesystem::exists(file))
        throw Error(file.string(), "the world that " + session + " was photographed in is not there",
                    "give the folder with the worlds, each named as the map that was inspected");
    return file;
}

ReadSession readSession(const std::string& file, const std::string& worlds, Progress& progress) {
    progress.report("reading the session", 0.0);
    const InspectionState state = SessionFile::openForReading(file)->load();
    ReadSession session;
    session.file = file;
    session.id = state.header.id;
    session.labelSet = state.labelSet;
    session.decisions = state.decisions;
    for (const Photo& photo : state.photos)
        session.photoIds.push_back(photo.id);
    if (worlds.empty()) {
        session.actual = recordedActualLabels(state);
        session.truth = "recorded by the simulated labeller";
    } else {
        const std::filesystem::path world = worldFileFor(worlds, file, state);
        session.actual = actualLabelsIn(world, state, progress);
        session.truth = world.string();
    }
    return session;
}

void execute(const Options& options, Context& context) {
    requireWritable(options.out);
    std::vector<ReadSession> sessions;
    for (const std::string& file : options.sessions)
        sessions.push_back(readSession(file, options.worlds, context.progress));
    const ReaderAgreement agreement = readerAgreement(sessions, isSimulatedLabeller);
    writeFile(options.out, agreementJson(agreement, sessions));
    context.out << agreementText(agreement, sessions);
}

}  // namespace

void addAgreementCommand(CLI::App& program, Run& run) {
    const auto options = std::make_shared<Options>();
    CLI::App* command =
        program.add_subcommand("agreement", "count how well readers name what photos show, and how far they agree");
    command->add_option("sessions", options->sessions, "sessions whose photos were labelled")
        ->required()
        ->type_name("SESSION.fodscope");
    command->add_option("--worlds", options->worlds, "folder with the worlds that the photos were taken in")
        ->type_name("DIR");
    command->add_option("--out", options->out, "file to write to")->required()->type_name("agreement.json");
    command->callback([options, &run] { run = [options](Context& context) { execute(*options, context); }; });
}

}  // namespace fodscope::cli
