// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>
#include <ostream>

#include "app/cli/commands/Commands.h"
#include "core/common/Error.h"
#include "storage/SessionFile.h"

namespace fodscope::cli {
namespace {

struct Options {
    std::string session;
    std::string head;
};

void execute(const Options& options, Context& context) {
    const std::unique_ptr<SessionFile> session = SessionFile::open(options.session);
    const SessionVerification verification = session->verify();
    if (!verification.intact) {
        throw Error(options.session, "was altered: " + verification.problem, "go back to a copy that is intact");
    }
    if (!options.head.empty() && !session->chainHolds(options.head)) {
        throw Error(options.session, "is intact, but " + options.head + " is not in its chain of acts",
                    "check that the hash is whole and that this is the session it was taken from");
    }
    context.out << options.session << ": intact, " << verification.acts << " acts, head " << verification.headHash
                << "\n";
    if (!options.head.empty()) context.out << options.head << ": in the chain\n";
}

}  // namespace

void addVerifyCommand(CLI::App& program, Run& run) {
    const auto options = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("verify", "check that a session file was not altered");
    command->add_option("session", options->session, "session file")->required()->type_name("SESSION");
    command->add_option("--head", options->head, "a hash that must be in the chain of acts, as a report prints it")
        ->type_name("HASH");
    command->callback([options, &run] { run = [options](Context& context) { execute(*options, context); }; });
}

}  // namespace fodscope::cli
