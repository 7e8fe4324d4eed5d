// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/cloud/PointCloudIo.h"
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
        trial.fods.push_back(
            {fod["type"], {centroid[0], centroid[1], centroid[2]}, {size[0], size[1], size[2]}, 0.0, {}, 0.02});
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
        const VisitPlan plan = planVisits(trial.fods, collision, sight, trial.robot_map, {}, {}, progress);
        fods += static_cast<int>(plan.views.size());
        photographed += static_cast<int>(std::ranges::count(plan.views, 1.0, &CandidateView::share));
        EXPECT_LE(*plan.shortestTourLength_m, *plan.nearestNextLength_m);
        for (const Waypoint& waypoint : plan.waypoints) {
            if (!waypoint.pose_map) continue;
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

/// Share of the cells of one kind in `a` that have one of that kind within a cell in `b`.
double foundAgain(const OccupancyGrid& a, const OccupancyGrid& b, Cell kind) {
    int cells = 0, found = 0;
    for (int row = 0; row < a.height; ++row) {
        for (int column = 0; column < a.width; ++column) {
            if (a.at({column, row}) != kind) continue;
            ++cells;
            const CellIndex centre = b.cellAt(a.centreOf({column, row}));
            bool isThere = false;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const CellIndex index{centre.column + dx, centre.row + dy};
                    isThere = isThere || (b.contains(index) && b.at(index) == kind);
                }
            found += isThere ? 1 : 0;
        }
    }
    return static_cast<double>(found) / cells;
}

TEST(TankGrids, theOccupancyOfAMapIsThatOfItsGridFile) {
    const std::filesystem::path folder = tankFolder();
    if (!std::filesystem::exists(folder / "val_00.yaml")) {
        GTEST_SKIP() << "the tank maps are not at hand; set FODSCOPE_SHARED_DATA to their folder";
    }
    for (const char* name : {"val_03", "train_05"}) {
        const OccupancyGrid golden = readMapServerGrid(folder / (std::string(name) + ".yaml"));
        const auto json = nlohmann::json::parse(readTextFile(folder / (std::string(name) + ".json")));
        std::array<double, 16> rows{};
        for (std::size_t i = 0; i < 16; ++i)
            rows[i] = json["T_cad_from_map"][i / 4][i % 4];
        const PointCloud map = readPointCloud(folder / (std::string(name) + ".pcd"));
        const auto made = [&](double low_m, double high_m) {
            OccupancySettings settings;
            settings.obstacleMinimumHeight_m = low_m;
            settings.obstacleMaximumHeight_m = high_m;
            return occupancyFromMap(map.points, transformFromRows(rows, name), 0.0, settings);
        };
        // The grid files were made from four times as many points as the maps still have, so single cells differ.
        const OccupancyGrid own = made(0.13, 0.45);
        EXPECT_GT(foundAgain(golden, own, Cell::Occupied), 0.97) << name;
        EXPECT_GT(foundAgain(own, golden, Cell::Occupied), 0.99) << name;
        EXPECT_GT(foundAgain(golden, own, Cell::Free), 0.99) << name;
        // The paper's band takes the hoses that the robot drives over, and the plates over it, for obstacles.
        EXPECT_LT(foundAgain(made(0.05, 1.0), golden, Cell::Occupied), 0.9) << name;
    }
}

}  // namespace
}  // namespace fodscope
