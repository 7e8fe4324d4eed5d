// SPDX-License-Identifier: MIT
#pragma once

#include "app/cli/Context.h"

namespace fodscope::cli {

/// Each adds one command to the program; when the user names it, `run` becomes it.
void addReferenceCommand(CLI::App& program, Run& run);
void addDetectCommand(CLI::App& program, Run& run);
void addPlanCommand(CLI::App& program, Run& run);
void addTuneCommand(CLI::App& program, Run& run);
void addSimulateCommand(CLI::App& program, Run& run);
void addInspectCommand(CLI::App& program, Run& run);
void addRouteCommand(CLI::App& program, Run& run);
void addReportCommand(CLI::App& program, Run& run);
void addVerifyCommand(CLI::App& program, Run& run);
void addEvaluateCommand(CLI::App& program, Run& run);
void addCompareCommand(CLI::App& program, Run& run);
void addAgreementCommand(CLI::App& program, Run& run);
void addParamsCommand(CLI::App& program, Run& run);

}  // namespace fodscope::cli
