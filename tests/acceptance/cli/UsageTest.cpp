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
