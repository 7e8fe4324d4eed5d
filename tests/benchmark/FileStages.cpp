// SPDX-License-Identifier: MIT
#include "tests/benchmark/FileStages.h"

#include <memory>

#include "core/cloud/PointCloudIo.h"
#include "core/inspection/DetectionPipeline.h"
#include "core/inspection/ParameterTable.h"
#include "core/reference/ReferenceMapIo.h"

namespace fodscope {

double readPoints(const std::filesystem::path& cloud) {
    return static_cast<double>(readPointCloud(cloud).size());
}

double discrepantVoxels(const std::filesystem::path& map, const std::filesystem::path& reference, bool isAligned) {
    DetectionPipeline pipeline;
    pipeline.setReference(std::make_shared<const ReferenceMap>(readReferenceMap(reference)));
    pipeline.giveMap(readPointCloud(map));
    if (isAligned) pipeline.setGivenTransform(Transform::Identity());
    Progress progress;
    const DetectionResult& result = pipeline.run(presetParameters("paper-physical"), progress);
    return result.candidates ? static_cast<double>(result.candidates->pointsAboveThreshold) : 0.0;
}

}  // namespace fodscope
