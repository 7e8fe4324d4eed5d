// SPDX-License-Identifier: MIT
#include "core/simulation/BuiltinDemo.h"

#include "core/common/Error.h"

namespace fodscope {

DepthMappingSettings quickMapping() {
    DepthMappingSettings settings;
    settings.columns = 112;
    settings.rows = 63;
    settings.keyFrameSpacing_m = 0.12;
    settings.lookSpacing_m = 0.9;
    settings.mapMaximumPoints = 150000;
    return settings;
}

BuiltinTrials makeBuiltinTrials(const BuiltinTrialsSettings& settings, Progress& progress) {
    if (settings.nominalRuns < 1 || settings.nominalRuns > 100)
        throw Error("built-in tank", "the number of nominal maps is out of range", "choose 1 to 100");
    BuiltinTrials trials;
    trials.cad = builtinTankCad(settings.tank);
    const World empty = builtinWorld(settings.tank);
    World world = empty;
    placeFod(world, settings.fodSeed);
    for (int i = 0; i <= settings.nominalRuns; ++i) {
        const bool isTrial = i == settings.nominalRuns;
        DepthMappingSettings mapping = settings.mapping;
        mapping.seed = settings.mappingSeed + static_cast<std::uint64_t>(i);
        Progress one([&](const std::string& stage, double fraction) {
            progress.report(stage, (i + fraction) / (settings.nominalRuns + 1));
        });
        MappingRun run = mapWorld(isTrial ? world : empty, mapping, one);
        if (isTrial)
            trials.trial = std::move(run);
        else
            trials.nominal.push_back(std::move(run));
    }
    world.T_map_from_world = trials.trial.T_map_from_world;
    trials.world = std::make_shared<const World>(std::move(world));
    return trials;
}

}  // namespace fodscope
