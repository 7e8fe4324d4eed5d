// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>
#include <ostream>

#include "app/cli/ParameterOptions.h"
#include "app/cli/commands/Commands.h"

namespace fodscope::cli {

void addParamsCommand(CLI::App& program, Run& run) {
    const auto options = std::make_shared<ParameterOptions>();
    CLI::App* command = program.add_subcommand("params", "show the parameters of every stage");
    const std::string what = "print the whole parameter file of the preset";
    command->add_flag("--print-default", what)->required();
    addPresetOptions(*command, *options);
    command->callback([options, &run] {
        run = [options](Context& context) { context.out << parametersYaml(parametersOf(*options)); };
    });
}

}  // namespace fodscope::cli
