// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/common/Files.h"
#include "tests/acceptance/cli/RoomFiles.h"

namespace fodscope::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(Usage, WrongUsageExitsWithTwoAndSaysWhy) {
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {},
             {"dtect"},
             {"detect"},
             {"detect", "--reference", "r.ply", "--map", "m.pcd"},
             {"detect", "--reference", "r.ply", "--map", "m.pcd", "--out", "x", "--metric", "l3"},
             {"detect", "--reference", "r.ply", "--map", "m.pcd", "--out", "x", "--threshold", "many"},
             {"detect", "--reference", "r.ply", "--map", "m.pcd", "--out", "x", "--threshold", "-1"},
             {"detect", "--reference", "r.ply", "--map", "m.pcd", "--out", "x", "--preset", "other"},
             {"detect", "--reference", "r.ply", "--map", "m.pcd", "--out", "x", "--transform", "a", "--initial", "b"},
             {"reference", "--out", "r.ply"},
             {"reference", "--cad", "a.stl", "--maps", "m.pcd", "--out", "r.ply"},
             {"reference", "--cad", "a.stl", "--scale", "0", "--out", "r.ply"},
             {"reference", "--cad", "a.stl", "--weights", "mean", "--out", "r.ply"},
             {"reference", "--cad", "a.stl", "--transforms", "t.csv", "--out", "r.ply"},
             {"reference", "--maps", "m.pcd", "--covariance-maps", "n.pcd", "--out", "r.ply"},
             {"reference", "--maps", "m.pcd", "--spacing", "0.01", "--out", "r.ply"},
             {"reference", "--cad", "a.stl", "--covariance-maps", "m.pcd", "--voxel", "0.05", "--out", "r.ply"},
             {"reference", "--maps", "m.pcd", "--weights", "median", "--out", "r.ply"},
             {"reference", "--maps", "m.pcd", "--neighbours", "0", "--out", "r.ply"},
             {"plan", "--candidates", "c.json", "--grid", "g.yaml", "--out", "w.json"},
             {"plan", "--candidates", "c.json", "--grid", "g.yaml", "--robot", "1,2", "--out", "w.json"},
             {"simulate", "--world", "builtin", "--kind", "other", "--out", "x"},
             {"inspect", "--reference", "r", "--map", "m", "--robot", "walking", "--world", "builtin", "--session",
              "s"},
             {"verify"}}) {
        const Outcome outcome = runCli(arguments);
        EXPECT_EQ(outcome.exitCode, 2) << ::testing::PrintToString(arguments);
        EXPECT_THAT(outcome.err, Not(IsEmpty())) << ::testing::PrintToString(arguments);
        EXPECT_THAT(outcome.out, IsEmpty()) << ::testing::PrintToString(arguments);
    }
}

TEST(Usage, AllOptionsOutOfRangeAreToldAtOnce) {
    const Outcome reference =
        runCli({"reference", "--maps", "m.pcd", "--neighbours", "0", "--radius", "-1", "--sigma", "0", "--voxel", "nan",
                "--smoothing-voxel", "-1", "--regularisation", "-1", "--occupancy-quantile", "2", "--out", "r.ply"});
    EXPECT_EQ(reference.exitCode, 2);
    for (const char* key : {"covariance_neighbours", "covariance_radius_m", "covariance_sigma_m", "voxel_size_m",
                            "covariance_voxel_size_m", "covariance_regularisation_m2", "occupancy_quantile"})
        EXPECT_THAT(reference.err, HasSubstr(std::string("reference.") + key));
    const Outcome detect = runCli({"detect", "--reference", "r.ply", "--map", "m.pcd", "--out", "x", "--threshold",
                                   "-1", "--cluster-cutoff", "-1", "--min-points", "-1"});
    EXPECT_EQ(detect.exitCode, 2);
    for (const char* key : {"threshold", "cluster_cutoff_m", "minimum_points"})
        EXPECT_THAT(detect.err, HasSubstr(std::string("candidates.") + key));
}

TEST(Usage, APresetIsPrintedWhole) {
    const Outcome printed = runCli({"params", "--print-default", "--preset", "paper-simulation"});
    ASSERT_EQ(printed.exitCode, 0);
    for (const char* line : {"threshold: 1.75", "cluster_cutoff_m: 0.275", "down_sampling: random", "random_ratio: 0.1",
                             "smoothing_weights: gaussian", "covariance_weights: gaussian", "enabled: false"})
        EXPECT_THAT(printed.out, HasSubstr(line));
}

TEST(Usage, HelpAndVersionGoToStandardOutput) {
    const Outcome help = runCli({"--help"});
    EXPECT_EQ(help.exitCode, 0);
    for (const char* command : {"reference", "detect", "plan", "simulate", "inspect", "report", "verify", "params"}) {
        EXPECT_THAT(help.out, HasSubstr(command));
    }
    EXPECT_EQ(runCli({"detect", "--help"}).exitCode, 0);
    EXPECT_EQ(runCli({"--version"}).exitCode, 0);
}

TEST(Usage, ThePrintedParametersAreReadBack) {
    const Outcome printed = runCli({"params", "--print-default"});
    ASSERT_EQ(printed.exitCode, 0);
    EXPECT_THAT(printed.out, HasSubstr("threshold: 2.75"));
    TestFolder folder;
    writeFile(folder / "p.yaml", printed.out);
    const Outcome again = runCli({"params", "--print-default", "--params", (folder / "p.yaml").string()});
    EXPECT_EQ(again.exitCode, 0);
    EXPECT_EQ(again.out, printed.out);
}

TEST(Usage, AnUnknownParameterNamesTheNearestKnownOne) {
    TestFolder folder;
    writeFile(folder / "p.yaml", "discrepancy:\n  voxelsize_m: 0.02\n");
    const Outcome outcome = runCli({"params", "--print-default", "--params", (folder / "p.yaml").string()});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("discrepancy.voxel_size_m"));
}

}  // namespace
}  // namespace fodscope::test
