// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/common/Progress.h"
#include "core/simulation/BuiltinTank.h"
#include "core/simulation/DepthMapping.h"
#include "core/simulation/World.h"

namespace fodscope {

/// Writes one trial into a folder: NAME.pcd, NAME.json, NAME.yaml with NAME.pgm, and worlds/NAME.json with its meshes.
/// @throws Error when the folder cannot be written
void writeTrial(const std::filesystem::path& folder, const std::string& name, const World& world,
                const MappingRun& run);

/// `NAME.json` of a trial: transforms, start pose, FOD with their true and observed centroids, trajectories, drift.
std::string trialJson(const std::string& name, const World& world, const MappingRun& run);

enum class TrialKind { Nominal, Trial };

struct TrialSeriesSettings {
    /// The world to map; without it the built-in tank.
    std::optional<std::filesystem::path> worldFile;
    TrialKind kind = TrialKind::Nominal;
    int count = 1;
    /// Trial i takes seed + i.
    std::uint64_t seed = 1;
    BuiltinTankSettings tank;
    DepthMappingSettings mapping;
};

/// Simulates nominal maps (FOD taken out of the world) or trials (FOD placed anew by the paper's protocol) and writes
/// them as they come, with the mesh `tank.ply`: the built-in tank as drawn, or the structure of the world given.
/// @return the trials' names
std::vector<std::string> simulateTrials(const std::filesystem::path& folder, const TrialSeriesSettings& settings,
                                        Progress& progress);

}  // namespace fodscope
