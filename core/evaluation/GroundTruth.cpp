// SPDX-License-Identifier: MIT
#include "core/evaluation/GroundTruth.h"

#include <algorithm>
#include <set>
#include <system_error>

#include "core/common/Error.h"
#include "core/evaluation/TruthReader.h"

namespace fodscope {
namespace {

constexpr const char* kRemedy =
    "give every trial NAME.pcd and NAME.json with \"fods\", each of them with \"type\" and \"gt_centroid_map\"";

struct FolderNames {
    std::set<std::string> maps;
    std::set<std::string> truths;
};

FolderNames namesIn(const std::filesystem::path& folder) {
    std::error_code failure;
    if (!std::filesystem::is_directory(folder, failure))
        throw Error(folder.string(), "is no folder", "give the folder that holds the trials");
    FolderNames names;
    std::filesystem::directory_iterator entry(folder, failure);
    for (const std::filesystem::directory_iterator end; !failure && entry != end; entry.increment(failure)) {
        const std::filesystem::path file = entry->path();
        if (file.extension() == ".pcd") names.maps.insert(file.stem().string());
        if (file.extension() == ".json") names.truths.insert(file.stem().string());
    }
    if (failure) throw Error(folder.string(), "cannot be read (" + failure.message() + ")", "check its permissions");
    return names;
}

Trial trialOf(const std::filesystem::path& folder, const std::string& name, TruthProblems& problems) {
    Trial trial;
    trial.name = name;
    trial.map = folder / (name + ".pcd");
    readTruth(folder / (name + ".json"), trial, problems);
    std::error_code ignored;
    const std::filesystem::path grid = folder / (name + ".yaml");
    if (std::filesystem::is_regular_file(grid, ignored)) trial.grid = grid;
    return trial;
}

void requireNoProblems(const std::filesystem::path& folder, const TruthProblems& problems) {
    if (problems.empty()) return;
    std::string text;
    for (const TruthProblem& problem : problems)
        text += (text.empty() ? "" : ", ") + problem.file + ": " + problem.text;
    const bool isOneFile =
        std::ranges::all_of(problems, [&](const TruthProblem& problem) { return problem.file == problems[0].file; });
    if (!isOneFile) throw Error(folder.string(), text, kRemedy);
    text.clear();
    for (const TruthProblem& problem : problems)
        text += (text.empty() ? "" : ", ") + problem.text;
    throw Error((folder / problems[0].file).string(), text, kRemedy);
}

}  // namespace

std::vector<Trial> readTrials(const std::filesystem::path& folder) {
    const FolderNames names = namesIn(folder);
    TruthProblems problems;
    std::vector<Trial> trials;
    for (const std::string& name : names.maps) {
        if (names.truths.contains(name))
            trials.push_back(trialOf(folder, name, problems));
        else
            problems.push_back({name + ".pcd", "its ground truth " + name + ".json is missing"});
    }
    for (const std::string& name : names.truths) {
        if (!names.maps.contains(name) && isTruth(folder / (name + ".json")))
            problems.push_back({name + ".json", "its map " + name + ".pcd is missing"});
    }
    requireNoProblems(folder, problems);
    if (trials.empty()) throw Error(folder.string(), "holds no trials", kRemedy);
    return trials;
}

}  // namespace fodscope
