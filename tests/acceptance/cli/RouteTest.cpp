// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/cloud/PointCloudIo.h"
#include "core/common/Files.h"
#include "tests/acceptance/cli/Program.h"

namespace fodscope::test {
namespace {

using ::testing::HasSubstr;

const std::string kHead = "schema: fodscope.route/1\nframe: map\nposes:\n";

Outcome drive(const TestFolder& folder, const std::string& poses) {
    writeFile(folder / "route.yaml", kHead + poses);
    return runCli({"route", "--poses", (folder / "route.yaml").string(), "--robot", "simulated", "--world", "builtin",
                   "--session", (folder / "route.fodscope").string(), "--out", (folder / "map.pcd").string()});
}

TEST(Route, IsDrivenInTheBuiltinTankAndTheMapIsFetched) {
    const TestFolder folder;
    const Outcome outcome = drive(folder,
                                  "  - {x: 1.0, y: 1.0, yaw_deg: 0, photo: true}\n"
                                  "  - {x: 1.6, y: 0.9, yaw_deg: 90}\n");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("2 of 2 poses driven, 1 photos"));
    EXPECT_GT(readPointCloud(folder / "map.pcd").size(), 1000U);
    const Outcome verified = runCli({"verify", (folder / "route.fodscope").string()});
    EXPECT_EQ(verified.exitCode, 0) << verified.err;
}

TEST(Route, WhatIsWrongWithTheFileIsToldWithItsLineAndNothingIsMade) {
    const TestFolder folder;
    const Outcome outcome = drive(folder, "  - {x: 1.0, y: one, yaw_deg: 0}\n");
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("route.yaml: line 4: 'y' is 'one', which is no number"));
    EXPECT_FALSE(std::filesystem::exists(folder / "route.fodscope"));
    EXPECT_FALSE(std::filesystem::exists(folder / "map.pcd"));
}

}  // namespace
}  // namespace fodscope::test
