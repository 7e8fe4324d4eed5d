// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "core/common/Progress.h"
#include "core/simulation/BuiltinTank.h"
#include "core/simulation/DepthMapping.h"
#include "core/simulation/World.h"

namespace fodscope {

/// Depth images small enough that all maps of the built-in tank are there within seconds.
DepthMappingSettings quickMapping();

struct BuiltinTrialsSettings {
    BuiltinTankSettings tank;
    DepthMappingSettings mapping = quickMapping();
    int nominalRuns = 6;
    /// What lies in the tank and where; the default puts four tools of different size into it.
    std::uint64_t fodSeed = 8;
    std::uint64_t mappingSeed = 100;
};

/// The built-in tank with all that an inspection of it starts from.
struct BuiltinTrials {
    TriangleMesh cad;
    /// With FOD; `T_map_from_world` is the trial's.
    std::shared_ptr<const World> world;
    std::vector<MappingRun> nominal;
    MappingRun trial;
};

/// Simulates the nominal maps and one trial. The same settings give the same maps.
BuiltinTrials makeBuiltinTrials(const BuiltinTrialsSettings& settings, Progress& progress);

}  // namespace fodscope
