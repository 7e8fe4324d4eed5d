// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/evaluation/TrialSelection.h"

namespace CLI {
class App;
}

namespace fodscope::cli {

/// What the commands that run on a folder of trials have in common.
struct TrialOptions {
    std::string reference;
    std::string trials;
    bool storedTransforms = false;

    TrialPlacement placement() const {
        return storedTransforms ? TrialPlacement::Stored : TrialPlacement::Registered;
    }
};

/// --reference, --trials and --stored-transforms
void addTrialOptions(CLI::App& command, TrialOptions& options);

}  // namespace fodscope::cli
