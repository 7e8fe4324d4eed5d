// SPDX-License-Identifier: MIT
#include "core/simulation/World.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "SmallWorlds.h"
#include "core/common/Error.h"
#include "core/common/Files.h"

namespace fodscope {
namespace {

class WorldFile : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = std::filesystem::path(::testing::TempDir()) /
                  ("fodscope_world_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
        file_ = folder_ / "trial.json";
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    static World sample() {
        World world = test::room();
        world.name = "trial";
        world.objects.push_back(test::boxObject({1.0, 0.5, 0.0}, {1.2, 0.6, 0.1}));
        WorldObject cover = test::boxObject({0.2, 0.2, 0.9}, {0.6, 0.6, 0.92});
        cover.type = "access hole cover";
        cover.fod = false;
        world.objects.push_back(cover);
        world.T_map_from_world.linear() = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()).toRotationMatrix();
        world.T_map_from_world.translation() = Eigen::Vector3d(0.1, -0.2, 0.3);
        world.robotStart_world = {1.5, 1.0, 0.25};
        return world;
    }

    /// Writes the sample, changes its JSON, and returns the message of reading it, or "" when it reads.
    std::string messageAfter(const std::function<void(nlohmann::json&)>& change) {
        writeWorld(file_, sample());
        nlohmann::json root = nlohmann::json::parse(readTextFile(file_));
        change(root);
        writeFile(file_, root.dump());
        return messageOfReading();
    }

    std::string messageOfReading() {
        try {
            readWorld(file_);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

    std::filesystem::path folder_;
    std::filesystem::path file_;
};

TEST_F(WorldFile, ComesBackAsItWasWritten) {
    const World written = sample();
    writeWorld(file_, written);
    const World read = readWorld(file_);
    EXPECT_EQ(read.name, "trial");
    ASSERT_EQ(read.objects.size(), 2u);
    EXPECT_EQ(read.objects[0].type, "box");
    EXPECT_TRUE(read.objects[0].fod);
    EXPECT_EQ(read.objects[1].type, "access hole cover");
    EXPECT_FALSE(read.objects[1].fod);
    EXPECT_TRUE(read.objects[0].centroid_world.isApprox(written.objects[0].centroid_world));
    EXPECT_TRUE(read.T_map_from_world.matrix().isApprox(written.T_map_from_world.matrix(), 1e-12));
    EXPECT_NEAR(read.robotStart_world.yaw_rad, 0.25, 1e-12);
    ASSERT_EQ(read.structure.triangles.size(), written.structure.triangles.size());
    EXPECT_TRUE(boundsOf(read.structure).isApprox(boundsOf(written.structure), 1e-6));
    EXPECT_EQ(read.objects[0].mesh.colours, written.objects[0].mesh.colours);
}

TEST_F(WorldFile, TheMatrixIsStoredRowByRow) {
    writeWorld(file_, sample());
    const nlohmann::json root = nlohmann::json::parse(readTextFile(file_));
    EXPECT_EQ(root["schema"], "fodscope.world/1");
    EXPECT_NEAR(root["T_map_from_world"][0][3].get<double>(), 0.1, 1e-12);
    EXPECT_NEAR(root["T_map_from_world"][0][1].get<double>(), -std::sin(0.3), 1e-12);
}

TEST_F(WorldFile, AMissingCentroidIsTheMeshsOwn) {
    EXPECT_EQ(messageAfter([](nlohmann::json& root) { root["objects"][0].erase("centroid"); }), "");
    EXPECT_TRUE(readWorld(file_).objects[0].centroid_world.isApprox(Eigen::Vector3d(1.1, 0.55, 0.05), 1e-6));
}

TEST_F(WorldFile, MissingKeysAreNamed) {
    for (const char* key : {"structure", "objects", "T_map_from_world", "robot_start"}) {
        const std::string message = messageAfter([&](nlohmann::json& root) { root.erase(key); });
        EXPECT_NE(message.find(key), std::string::npos) << key << ": " << message;
        EXPECT_NE(message.find("trial.json"), std::string::npos) << message;
    }
}

TEST_F(WorldFile, HostileValuesAreRefused) {
    using nlohmann::json;
    EXPECT_NE(messageAfter([](json& root) { root["schema"] = "fodscope.world/9"; }), "");
    EXPECT_NE(messageAfter([](json& root) { root["structure"] = 7; }), "");
    EXPECT_NE(messageAfter([](json& root) { root["structure"] = "absent.ply"; }), "");
    EXPECT_NE(messageAfter([](json& root) { root["objects"] = "none"; }), "");
    EXPECT_NE(messageAfter([](json& root) { root["objects"][0] = nullptr; }), "");
    EXPECT_NE(messageAfter([](json& root) { root["objects"][0]["fod"] = "yes"; }), "");
    EXPECT_NE(messageAfter([](json& root) { root["objects"][0]["centroid"] = {1, 2}; }), "");
    EXPECT_NE(messageAfter([](json& root) { root["T_map_from_world"] = json::array(); }), "");
    EXPECT_NE(messageAfter([](json& root) { root["T_map_from_world"][0][0] = 5.0; }), "") << "no rotation";
    EXPECT_NE(messageAfter([](json& root) { root["T_map_from_world"][0] = {1, 0, 0}; }), "");
    EXPECT_NE(messageAfter([](json& root) { root["robot_start"].erase("yaw_deg"); }), "");
    EXPECT_NE(messageAfter([](json& root) { root["robot_start"]["x"] = "left"; }), "");
}

TEST_F(WorldFile, DamagedFilesAreRefused) {
    writeWorld(file_, sample());
    const std::string whole = readTextFile(file_);
    for (const std::size_t length : {std::size_t{0}, std::size_t{1}, whole.size() / 2, whole.size() - 3}) {
        writeFile(file_, std::string_view(whole).substr(0, length));
        EXPECT_NE(messageOfReading(), "") << length;
    }
    writeFile(file_, std::string_view("\x89PNG\r\n\x1a\n"));
    EXPECT_NE(messageOfReading(), "");
    std::filesystem::remove(file_);
    EXPECT_NE(messageOfReading(), "");
}

TEST_F(WorldFile, TypesThatAreNoFileNamesStayInsideTheFolder) {
    World world = sample();
    world.objects[0].type = "../../etc/passwd";
    writeWorld(file_, world);
    EXPECT_EQ(readWorld(file_).objects[0].type, "../../etc/passwd");
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_))
        if (entry.is_regular_file()) ++files;
    EXPECT_EQ(files, 4u);
}

TEST(NuwcWorld, TheRealTankReads) {
    const char* shared = std::getenv("FODSCOPE_SHARED_DATA");
    const std::filesystem::path data =
        shared ? std::filesystem::path(shared) : std::filesystem::path(FODSCOPE_RESOURCES) / "../../shared/data";
    const std::filesystem::path file = data / "nuwc-tank/worlds/val_03.json";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no NUWC tank data; set FODSCOPE_SHARED_DATA";
    const World world = readWorld(file);
    ASSERT_EQ(world.objects.size(), 5u);
    EXPECT_EQ(world.objects[0].type, "drill");
    EXPECT_FALSE(world.objects[4].fod);
    EXPECT_NEAR(world.robotStart_world.x_m, 0.8956, 1e-4);
    // The start in the map frame, as the trial's own file has it.
    const Pose2 start_map = poseFromTransform(world.T_map_from_world * transformFromPose(world.robotStart_world));
    EXPECT_NEAR(start_map.x_m, 0.7745, 1e-3);
    EXPECT_NEAR(start_map.y_m, 0.7071, 1e-3);
    EXPECT_NEAR(degreesFromRadians(start_map.yaw_rad), 84.79, 0.01);
    EXPECT_NEAR(boundsOf(world.structure).max().x(), 6.1976, 1e-3);
}

}  // namespace
}  // namespace fodscope
