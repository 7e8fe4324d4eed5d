// SPDX-License-Identifier: MIT
#include "core/simulation/Trials.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "SmallWorlds.h"
#include "core/cloud/MeshIo.h"
#include "core/cloud/PointCloudIo.h"
#include "core/common/Error.h"
#include "core/common/Files.h"
#include "core/planning/OccupancyGrid.h"

namespace fodscope {
namespace {

class TrialFolder : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = std::filesystem::path(::testing::TempDir()) /
                  ("fodscope_trials_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::remove_all(folder_);
        settings_.mapping.columns = 48;
        settings_.mapping.rows = 27;
        settings_.mapping.keyFrameSpacing_m = 0.2;
        settings_.mapping.lookSpacing_m = 1.5;
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    nlohmann::json parsed(const std::string& name) const { return nlohmann::json::parse(readTextFile(folder_ / name)); }

    std::filesystem::path folder_;
    TrialSeriesSettings settings_;
};

TEST_F(TrialFolder, ATrialHoldsAllThatEvaluationNeeds) {
    settings_.kind = TrialKind::Trial;
    Progress progress;
    const std::vector<std::string> names = simulateTrials(folder_, settings_, progress);
    ASSERT_EQ(names, std::vector<std::string>{"trial_00"});
    const nlohmann::json trial = parsed("trial_00.json");
    EXPECT_EQ(trial["name"], "trial_00");
    const PointCloud map = readPointCloud(folder_ / "trial_00.pcd");
    EXPECT_EQ(trial["points"], map.size());
    EXPECT_EQ(map.colours.size(), map.size());
    const OccupancyGrid grid = readMapServerGrid(folder_ / "trial_00.yaml");
    EXPECT_GT(grid.width, 50);
    const World world = readWorld(folder_ / "worlds/trial_00.json");
    ASSERT_EQ(trial["fods"].size(), world.objects.size());
    for (std::size_t i = 0; i < world.objects.size(); ++i) {
        const nlohmann::json& fod = trial["fods"][i];
        EXPECT_EQ(fod["type"], world.objects[i].type);
        EXPECT_EQ(fod["observed"], fod["map_points_hit"].get<int>() >= 5);
        // The world's transform takes the true centroid to where the trial says it is.
        const Eigen::Vector3d expected = world.T_map_from_world * world.objects[i].centroid_world;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(fod["centroid_map"][axis].get<double>(), expected[static_cast<int>(axis)], 1e-9);
            EXPECT_NEAR(fod["gt_centroid_map"][axis].get<double>(), expected[static_cast<int>(axis)], 0.2);
        }
    }
    Eigen::Matrix4d forth, back;
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
            forth(static_cast<int>(row), static_cast<int>(column)) = trial["T_map_from_cad"][row][column];
            back(static_cast<int>(row), static_cast<int>(column)) = trial["T_cad_from_map"][row][column];
        }
    }
    EXPECT_TRUE((forth * back).isApprox(Eigen::Matrix4d::Identity(), 1e-9));
    EXPECT_TRUE(forth.isApprox(world.T_map_from_world.matrix(), 1e-12));
    EXPECT_EQ(trial["trajectory_estimated_map"].size(), trial["frames"]);
    EXPECT_EQ(trial["trajectory_true_cad"][0].size(), 7u);
    EXPECT_NEAR(trial["trajectory_true_cad"][0][2].get<double>(), 0.20, 1e-6);
    EXPECT_TRUE(trial["robot_start_pose_map"].contains("yaw_deg"));
    EXPECT_GT(trial["drift"]["std_xy_m"].get<double>(), 0.0);
    EXPECT_LT(trial["drift"]["std_xy_m"].get<double>(), 0.02);
    EXPECT_FALSE(readMesh(folder_ / "tank.ply").triangles.empty());
}

TEST_F(TrialFolder, NominalMapsHaveNoFodAndDifferFromOneAnother) {
    settings_.count = 2;
    Progress progress;
    simulateTrials(folder_, settings_, progress);
    EXPECT_TRUE(parsed("nominal_00.json")["fods"].empty());
    EXPECT_NE(readFile(folder_ / "nominal_00.pcd"), readFile(folder_ / "nominal_01.pcd"));
}

TEST_F(TrialFolder, TheSameSeedWritesTheSameBytes) {
    Progress progress;
    simulateTrials(folder_ / "a", settings_, progress);
    simulateTrials(folder_ / "b", settings_, progress);
    for (const char* file : {"nominal_00.pcd", "nominal_00.json", "nominal_00.pgm", "worlds/nominal_00.json"})
        EXPECT_EQ(readFile(folder_ / "a" / file), readFile(folder_ / "b" / file)) << file;
}

TEST_F(TrialFolder, ANominalMapOfAWorldLeavesItsFodOut) {
    World world = test::room();
    world.objects.push_back(test::boxObject({2.2, 1.3, 0.0}, {2.4, 1.5, 0.12}));
    world.objects.push_back(test::boxObject({0.2, 0.2, 0.0}, {0.3, 0.3, 0.1}));
    world.objects[1].fod = false;
    makeFolder(folder_);
    writeWorld(folder_ / "given.json", world);
    settings_.worldFile = folder_ / "given.json";
    Progress progress;
    simulateTrials(folder_ / "out", settings_, progress);
    const World mapped = readWorld(folder_ / "out/worlds/nominal_00.json");
    ASSERT_EQ(mapped.objects.size(), 1u);
    EXPECT_FALSE(mapped.objects[0].fod);
}

TEST_F(TrialFolder, AnImpossibleCountIsRefused) {
    Progress progress;
    settings_.count = 0;
    EXPECT_THROW(simulateTrials(folder_, settings_, progress), Error);
}

}  // namespace
}  // namespace fodscope
