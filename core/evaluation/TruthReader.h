// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/evaluation/GroundTruth.h"

namespace fodscope {

/// What is wrong with the ground truth in one file, naming the field.
struct TruthProblem {
    std::string file;
    std::string text;
};
using TruthProblems = std::vector<TruthProblem>;

/// Reads NAME.json into a trial. Every problem is added; the trial is whole when none was.
void readTruth(const std::filesystem::path& file, Trial& trial, TruthProblems& problems);

/// @return whether a JSON file is a trial's ground truth: an object with "fods"
bool isTruth(const std::filesystem::path& file);

}  // namespace fodscope
