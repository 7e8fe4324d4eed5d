// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>
#include <ostream>

#include "app/cli/commands/Commands.h"
#include "core/common/Files.h"
#include "core/evaluation/Comparison.h"

namespace fodscope::cli {
namespace {

struct Options {
    std::string a;
    std::string b;
    std::string out;
};

void execute(const Options& options, Context& context) {
    const Comparison comparison = compareEvaluations(readEvaluation(options.a), readEvaluation(options.b));
    if (!options.out.empty()) writeFile(options.out, comparisonJson(comparison));
    context.out << comparisonText(comparison);
}

}  // namespace

void addCompareCommand(CLI::App& program, Run& run) {
    const auto options = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("compare", "test whether two evaluations of the same trials differ");
    command->add_option("a", options->a, "one evaluation")->required()->type_name("A.json");
    command->add_option("b", options->b, "the other")->required()->type_name("B.json");
    command->add_option("--out", options->out, "file to write the tests to")->type_name("comparison.json");
    command->callback([options, &run] { run = [options](Context& context) { execute(*options, context); }; });
}

}  // namespace fodscope::cli
