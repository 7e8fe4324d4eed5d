// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <iostream>
#include <new>
#include <sstream>

#include "app/cli/ConsoleProgress.h"
#include "app/cli/Interrupt.h"
#include "app/cli/commands/Commands.h"
#include "core/common/Error.h"
#include "core/common/Version.h"

namespace {

enum ExitCode { kDone = 0, kInputAtFault = 1, kWrongUsage = 2, kCancelled = 3 };

void addCommands(CLI::App& program, fodscope::cli::Run& run) {
    using namespace fodscope::cli;
    addReferenceCommand(program, run);
    addDetectCommand(program, run);
    addPlanCommand(program, run);
    addSimulateCommand(program, run);
    addRouteCommand(program, run);
    addInspectCommand(program, run);
    addReportCommand(program, run);
    addVerifyCommand(program, run);
    addEvaluateCommand(program, run);
    addTuneCommand(program, run);
    addCompareCommand(program, run);
    addAgreementCommand(program, run);
    addParamsCommand(program, run);
}

int fail(ExitCode code, const std::string& text) {
    fodscope::cli::clearProgressLine();
    std::cerr << text << "\n";
    return code;
}

int execute(const fodscope::cli::Run& run, fodscope::Progress& progress) {
    try {
        std::ostringstream out;
        fodscope::cli::Context context{progress, out, std::cerr};
        run(context);
        fodscope::cli::clearProgressLine();
        std::cout << out.str() << std::flush;
        if (!std::cout) return fail(kInputAtFault, "error: standard output: cannot be written; check where it goes");
        return kDone;
    } catch (const fodscope::Cancelled&) {
        return fail(kCancelled, "cancelled");
    } catch (const fodscope::cli::UsageError& error) {
        return fail(kWrongUsage, error.what());
    } catch (const fodscope::Error& error) {
        return fail(kInputAtFault, std::string("error: ") + error.what());
    } catch (const std::bad_alloc&) {
        return fail(kInputAtFault, "error: memory: there is not enough for this input; give a smaller or coarser one");
    } catch (const std::exception& error) {
        return fail(kInputAtFault, std::string("error: fodscope-cli: ") + error.what() + "; please report this");
    }
}

}  // namespace

int main(int argc, char** argv) {
    fodscope::Progress progress(fodscope::cli::consoleProgress());
    const fodscope::cli::Interrupt interrupt(progress);
    CLI::App program(
        "Fodscope finds foreign object debris: it compares maps, lists candidates and records inspections.",
        "fodscope-cli");
    program.set_version_flag("--version", std::string(fodscope::kVersion));
    program.require_subcommand(1);
    fodscope::cli::Run run;
    addCommands(program, run);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? kDone : kWrongUsage;
    }
    return execute(run, progress);
}
