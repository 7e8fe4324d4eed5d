// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/common/Files.h"
#include "tests/acceptance/SharedData.h"
#include "tests/acceptance/cli/Program.h"

namespace fodscope::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class RealTank : public ::testing::Test {
  protected:
    void SetUp() override {
        if (!std::filesystem::exists(data_ / "val_03.pcd")) {
            GTEST_SKIP() << data_ << " is not there; set FODSCOPE_SHARED_DATA to the folder with the real tanks' data";
        }
    }

    std::string file(const std::string& name) const { return (data_ / name).string(); }

    std::filesystem::path data_ = sharedData() / "nuwc-tank";
    TestFolder folder_;
};

double distance(const json& a, const json& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
        sum += std::pow(a[i].get<double>() - b[i].get<double>(), 2);
    return std::sqrt(sum);
}

/// With few nominal maps to be quick: what is tested is that the whole chain works on a real tank.
TEST_F(RealTank, Val03IsInspectedInItsOwnWorldAndOnItsOwnGrid) {
    const std::string reference = (folder_ / "reference.ply").string();
    const Outcome made =
        runCli({"reference", "--maps", file("train_00.pcd"), file("train_01.pcd"), file("train_02.pcd"),
                file("train_03.pcd"), "--align-to", file("tank.ply"), "--out", reference});
    ASSERT_EQ(made.exitCode, 0) << made.err;

    const Outcome detected = runCli(
        {"detect", "--reference", reference, "--map", file("val_03.pcd"), "--out", (folder_ / "detect").string()});
    ASSERT_EQ(detected.exitCode, 0) << detected.err;
    const json candidates = json::parse(readTextFile(folder_ / "detect" / "candidates.json"))["candidates"];
    const json truth = json::parse(readTextFile(data_ / "val_03.json"));
    for (const json& fod : truth["fods"]) {
        if (fod["type"] != "drill" && fod["type"] != "sander") continue;
        double nearest_m = 1e9;
        for (const json& candidate : candidates) {
            nearest_m = std::min(nearest_m, distance(candidate["centroid_map"], fod["gt_centroid_map"]));
        }
        EXPECT_LT(nearest_m, 0.15) << fod["type"];
    }

    const std::string session = (folder_ / "val_03.fodscope").string();
    const Outcome inspected =
        runCli({"inspect", "--reference", reference, "--map", file("val_03.pcd"), "--robot", "simulated", "--world",
                file("worlds/val_03.json"), "--grid", file("val_03.yaml"), "--session", session});
    ASSERT_EQ(inspected.exitCode, 0) << inspected.err;
    EXPECT_EQ(runCli({"verify", session}).exitCode, 0);
    const std::string report = (folder_ / "report.csv").string();
    ASSERT_EQ(runCli({"report", session, "--out", report}).exitCode, 0);
    const std::string csv = readTextFile(report);
    EXPECT_THAT(csv, HasSubstr("drill"));
    EXPECT_THAT(csv, HasSubstr("sander"));
}

}  // namespace
}  // namespace fodscope::test
