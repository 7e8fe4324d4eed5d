// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/common/Files.h"
#include "core/planning/Waypoints.h"

namespace fodscope {
namespace {

std::filesystem::path tankFolder() {
    const char* shared = std::getenv("FODSCOPE_SHARED_DATA");
    const std::filesystem::path beside = std::filesystem::path(FODSCOPE_TEST_DATA) / "../../../shared/data";
    return (shared != nullptr ? std::filesystem::path(shared) : beside) / "nuwc-tank";
}

struct Trial {
    OccupancyGrid grid;
    Pose2 robot_map;
    std::vector<PlanTarget> fods;
};

Trial readTrial(const std::filesystem::path& folder, const std::string& name) {
    Trial trial;
    trial.grid = readMapServerGrid(folder / (name + ".yaml"));
    const auto json = nlohmann::json::parse(readTextFile(folder / (name + ".json")));
    const auto& start = json["robot_start_pose_map"];
    trial.robot_map = {start["x"], start["y"], radiansFromDegrees(start["yaw_deg"])};
    for (const auto& fod : json["fods"]) {
        const auto centroid = fod["gt_centroid_map"].get<std::vector<double>>();
        const auto size = fod["size_m"].get<std::vector<double>>();
        trial.fods.push_back({fod["type"], {centroid[0], centroid[1], centroid[2]}, {size[0], size[1], size[2]}});
    }
    return trial;
}

/// Points all over a FOD's outline, as a detection would mark them.
void addOutline(const PlanTarget& fod, std::vector<Eigen::Vector3d>& points) {
    const double radius_m = 0.5 * fod.size_m.head<2>().minCoeff();
    for (double x = -radius_m; x <= radius_m; x += 0.02) {
        for (double y = -radius_m; y <= radius_m; y += 0.02) {
            points.push_back(fod.centroid_map + Eigen::Vector3d(x, y, 0.0));
        }
    }
}

TEST(TankGrids, nearlyEveryFodOfTheTrialsGetsAClearWaypoint) {
    const std::filesystem::path folder = tankFolder();
    if (!std::filesystem::exists(folder / "val_00.yaml")) {
        GTEST_SKIP() << "the tank maps are not at hand; set FODSCOPE_SHARED_DATA to their folder";
    }
    int fods = 0;
    int photographed = 0;
    for (int number = 0; number < 15; ++number) {
        const std::string name = (number < 10 ? "val_0" : "val_") + std::to_string(number);
        const Trial trial = readTrial(folder, name);
        CostMap collision = inflate(trial.grid, {});
        floodFill(collision, trial.robot_map);
        std::vector<Eigen::Vector3d> discrepant;
        for (const PlanTarget& fod : trial.fods)
            addOutline(fod, discrepant);
        const CostMap sight = inflate(withoutCandidates(trial.grid, discrepant), {});
        Progress progress;
        const VisitPlan plan = planVisits(trial.fods, collision, sight, trial.robot_map, {}, progress);
        for (const Waypoint& waypoint : plan.waypoints) {
            ++fods;
            if (!waypoint.pose_map) continue;
            ++photographed;
            EXPECT_TRUE(collision.isReachable(trial.grid.cellAt({waypoint.pose_map->x_m, waypoint.pose_map->y_m})));
            for (std::size_t i = 1; i < waypoint.drive.points_map.size(); ++i) {
                EXPECT_TRUE(collision.isReachable(trial.grid.cellAt(waypoint.drive.points_map[i]))) << name;
            }
        }
        RecordProperty(name, std::to_string(plan.length_m));
    }
    EXPECT_EQ(fods, 48);
    // Three lie behind a low plate along the wall that the robot cannot look over.
    EXPECT_GE(photographed, 45);
}

}  // namespace
}  // namespace fodscope
