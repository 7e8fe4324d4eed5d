// SPDX-License-Identifier: MIT
// The same input gives the same files, to the byte, whatever the number of threads.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <map>

#include "core/cloud/PointCloudIo.h"
#include "core/common/Files.h"
#include "core/detection/DiscrepancyPly.h"
#include "core/inspection/DetectionPipeline.h"
#include "core/inspection/Inspection.h"
#include "core/inspection/ReferenceFiles.h"
#include "core/reference/ReferenceMapIo.h"
#include "core/simulation/BuiltinDemo.h"
#include "tests/unit/cloud/TemporaryFolder.h"

namespace fodscope {
namespace {

using Files = std::map<std::string, std::vector<std::byte>>;

BuiltinTrialsSettings fewFrames() {
    BuiltinTrialsSettings settings;
    settings.nominalRuns = 3;
    settings.mapping.columns = 64;
    settings.mapping.rows = 36;
    settings.mapping.keyFrameSpacing_m = 0.25;
    settings.mapping.mapMaximumPoints = 40000;
    return settings;
}

void detectWith(Metric metric, DetectionPipeline& pipeline, const std::filesystem::path& folder) {
    Progress progress;
    Parameters parameters = presetParameters("paper-physical");
    parameters.candidates = usualCandidateSettings(metric, parameters);
    const DetectionResult& result = pipeline.run(parameters, progress);
    ASSERT_NE(result.registration.quality, RegistrationQuality::Bad) << result.registration.summary;
    ASSERT_GT(result.candidates->candidates.size(), 1u);
    DetectionRecord record;
    record.parameters = parameters;
    record.registration = result.registration;
    record.floorHeight_m = result.floorHeight_m;
    record.field = result.field;
    record.candidates = result.candidates;
    record.coverage = result.coverage;
    const std::string name = std::to_string(static_cast<int>(metric));
    writeDiscrepancyPly(folder / ("discrepancy-" + name + ".ply"), *record.field, *record.candidates, metric);
    writeFile(folder / ("candidates-" + name + ".json"),
              candidatesJson({"ref.ply", "", 0}, {"map.pcd", "", 0}, record));
}

/// All from the simulated depth images to the candidates' files.
Files filesWith(std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const TemporaryFolder folder;
    Progress progress;
    const BuiltinTrials trials = makeBuiltinTrials(fewFrames(), progress);
    NominalMapsRequest request;
    for (const MappingRun& run : trials.nominal) {
        request.maps.push_back(folder / ("nominal-" + std::to_string(request.maps.size()) + ".pcd"));
        writePointCloud(request.maps.back(), run.map);
    }
    writePointCloud(folder / "map.pcd", trials.trial.map);
    const ReferenceMap made = referenceFromMapFiles(request, progress);
    writeReferenceMap(folder / "reference.ply", made);

    DetectionPipeline pipeline;
    pipeline.setReference(std::make_shared<const ReferenceMap>(readReferenceMap(folder / "reference.ply")));
    pipeline.setMap(std::make_shared<const PointCloud>(readPointCloud(folder / "map.pcd")));
    for (const Metric metric : {Metric::Euclidean, Metric::Mahalanobis, Metric::ChiSquare})
        detectWith(metric, pipeline, folder / "");
    Files files;
    for (const auto& entry : std::filesystem::directory_iterator(folder / ""))
        files[entry.path().filename().string()] = readFile(entry.path());
    return files;
}

TEST(Threads, OneAndTwoGiveTheSameFilesToTheByte) {
    const Files one = filesWith(1);
    const Files two = filesWith(2);
    ASSERT_EQ(one.size(), 11u);
    ASSERT_EQ(two.size(), one.size());
    for (const auto& [name, bytes] : one)
        EXPECT_TRUE(two.at(name) == bytes) << name;
}

}  // namespace
}  // namespace fodscope
