// SPDX-License-Identifier: MIT
#include "app/cli/TrialOptions.h"

#include <CLI/CLI.hpp>

namespace fodscope::cli {

void addTrialOptions(CLI::App& command, TrialOptions& options) {
    command.add_option("--reference", options.reference, "reference map (PLY)")->required()->type_name("REF.ply");
    command.add_option("--trials", options.trials, "folder with NAME.pcd and NAME.json of each trial")
        ->required()
        ->type_name("DIR");
    command.add_flag("--stored-transforms", options.storedTransforms,
                     "place each map by its T_cad_from_map instead of registering it");
}

}  // namespace fodscope::cli
