// SPDX-License-Identifier: MIT
#include "core/evaluation/TrialSelection.h"

#include "core/cloud/PointCloudIo.h"
#include "core/cloud/UnitCheck.h"

namespace fodscope {

TrialSelection selectTrials(std::span<const Trial> trials, TrialPlacement placement) {
    TrialSelection selection;
    std::string lacking;
    for (const Trial& trial : trials) {
        if (trial.isNominal()) {
            selection.nominalMaps.push_back(trial.name);
            continue;
        }
        selection.withFod.push_back(&trial);
        if (placement == TrialPlacement::Stored && !trial.T_cad_from_map)
            lacking += (lacking.empty() ? "" : ", ") + trial.name;
    }
    if (selection.withFod.empty()) {
        throw Error("trials", "all maps are nominal, there is no FOD to find in them",
                    "give a folder with maps whose \"fods\" is not empty");
    }
    if (!lacking.empty()) {
        throw Error("trials", "no T_cad_from_map is stored for " + lacking,
                    "leave --stored-transforms out, then the program registers the maps itself");
    }
    return selection;
}

DetectionPipeline pipelineFor(const Trial& trial, const std::shared_ptr<const ReferenceMap>& reference,
                              TrialPlacement placement) {
    auto map = std::make_shared<PointCloud>(readPointCloud(trial.map));
    requireUsableCloud(map->points, trial.map.string());
    DetectionPipeline pipeline;
    pipeline.setReference(reference);
    pipeline.setMap(std::move(map));
    if (placement == TrialPlacement::Stored)
        pipeline.setGivenTransform(trial.T_cad_from_map);
    else
        pipeline.setStart(trial.T_cad_from_map_initial);
    return pipeline;
}

void rethrowNaming(const Trial& trial, const Error& error) {
    if (error.subject() != "map") throw error;
    throw Error(trial.map.string(), error.problem(), error.remedy());
}

}  // namespace fodscope
