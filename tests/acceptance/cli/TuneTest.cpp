// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>

#include <algorithm>

#include "core/common/Files.h"
#include "tests/acceptance/cli/RoomFiles.h"
#include "tests/unit/registration/SyntheticRoom.h"

namespace fodscope::test {
namespace {

using ::testing::HasSubstr;

/// Two trials with the box of the room's map as FOD, and a nominal map.
void writeTrials(const std::filesystem::path& folder) {
    makeFolder(folder);
    const Eigen::Vector3d box = motion(1.0, {0.03, -0.02, 0.0}) * Eigen::Vector3d(2.1, 1.3, 0.1);
    const std::string truth = "{\"fods\": [{\"type\": \"box\", \"gt_centroid_map\": [" + std::to_string(box.x()) + "," +
                              std::to_string(box.y()) + "," + std::to_string(box.z()) + "]}]}";
    for (const char* name : {"a", "b"}) {
        std::filesystem::copy_file(roomFiles().map(), folder / (std::string(name) + ".pcd"));
        writeFile(folder / (std::string(name) + ".json"), truth);
    }
    std::filesystem::copy_file(roomFiles().nominalMaps()[0], folder / "nominal.pcd");
    writeFile(folder / "nominal.json", std::string("{\"fods\": []}"));
}

std::vector<std::string> tune(const TestFolder& folder, std::vector<std::string> more) {
    std::vector<std::string> arguments{"tune",
                                       "--reference",
                                       roomFiles().reference(),
                                       "--trials",
                                       (folder / "trials").string(),
                                       "--out",
                                       (folder / "best.yaml").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(Tune, WritesAParameterFileThatDetectionTakesAndTheCosts) {
    TestFolder folder;
    writeTrials(folder / "trials");
    const std::string csv = (folder / "surface.csv").string();
    const std::string png = (folder / "surface.png").string();
    const Outcome tuned = runCli(tune(
        folder, {"--metric", "euclidean", "--cutoffs", "0.1,0.6,3", "--thresholds", "auto,0.08,4", "--least-points",
                 "0,2", "--lambda", "0.1", "--linkage", "single", "--surface", csv, "--surface", png}));
    ASSERT_EQ(tuned.exitCode, 0) << tuned.err;
    EXPECT_THAT(tuned.out, HasSubstr("Best of 36 grid points over 2 trials with 2 FOD: threshold "));
    EXPECT_THAT(tuned.out, HasSubstr("1 nominal map was left out."));
    const std::string surface = readTextFile(csv);
    EXPECT_EQ(std::ranges::count(surface, '\n'), 37);
    EXPECT_EQ(readTextFile(png).substr(1, 3), "PNG");
    const std::string yaml = readTextFile(folder / "best.yaml");
    EXPECT_THAT(yaml, HasSubstr("# Best of 36 grid points"));
    EXPECT_THAT(yaml, HasSubstr("lambda 0.1 m"));
    EXPECT_THAT(yaml, HasSubstr("linkage: single"));
    const Outcome detected =
        runCli({"detect", "--reference", roomFiles().reference(), "--map", roomFiles().map(), "--params",
                (folder / "best.yaml").string(), "--out", (folder / "detection").string()});
    EXPECT_EQ(detected.exitCode, 0) << detected.err;
    EXPECT_THAT(detected.out, HasSubstr("candidates"));
}

TEST(Tune, RefusesGridsThatMeanNothing) {
    TestFolder folder;
    for (const std::vector<std::string>& options : std::vector<std::vector<std::string>>{{"--cutoffs", "0.1,0.6"},
                                                                                         {"--cutoffs", "auto,0.6,3"},
                                                                                         {"--cutoffs", "0.6,0.1,3"},
                                                                                         {"--cutoffs", "0.1,0.6,0"},
                                                                                         {"--thresholds", "2,x,3"},
                                                                                         {"--thresholds", "3,2,5"},
                                                                                         {"--least-points", "3"},
                                                                                         {"--least-points", "5,3"},
                                                                                         {"--lambda", "-1"},
                                                                                         {"--surface", "costs.txt"}}) {
        const Outcome outcome = runCli(tune(folder, options));
        EXPECT_EQ(outcome.exitCode, 2) << ::testing::PrintToString(options) << outcome.err;
        EXPECT_FALSE(outcome.err.empty());
    }
}

TEST(Tune, NeedsTrialsWithFod) {
    TestFolder folder;
    EXPECT_EQ(runCli(tune(folder, {})).exitCode, 1);
    makeFolder(folder / "trials");
    std::filesystem::copy_file(roomFiles().nominalMaps()[0], folder / "trials" / "nominal.pcd");
    writeFile(folder / "trials" / "nominal.json", std::string("{\"fods\": []}"));
    const Outcome nominal = runCli(tune(folder, {}));
    EXPECT_EQ(nominal.exitCode, 1);
    EXPECT_THAT(nominal.err, HasSubstr("all maps are nominal"));
    EXPECT_FALSE(std::filesystem::exists(folder / "best.yaml"));
}

TEST(Tune, AnInterruptLeavesNothingHalfWritten) {
    TestFolder folder;
    writeTrials(folder / "trials");
    Program program(tune(folder, {"--surface", (folder / "surface.csv").string()}));
    while (program.isRunning() && !program.hearsInterrupts())
        sched_yield();
    program.interrupt();
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.exitCode, 3) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "best.yaml"));
    EXPECT_FALSE(std::filesystem::exists(folder / "surface.csv"));
}

}  // namespace
}  // namespace fodscope::test
