// SPDX-License-Identifier: MIT
#include "core/planning/Waypoints.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/common/Error.h"
#include "core/planning/WaypointSearch.h"
#include "tests/fakes/PictureGrid.h"

namespace fodscope {
namespace {

PlanTarget targetAt(double x_m, double y_m, const std::string& id = "C-001") {
    return {id, {x_m, y_m, 0.05}, {0.2, 0.1, 0.1}, 0.0, {}, 0.02};
}

struct Room {
    explicit Room(const OccupancyGrid& grid, const Pose2& robot = {1.0, 1.0, 0.0})
        : collision(inflate(grid, {})), sight(collision), robot_map(robot) {
        floodFill(collision, robot_map);
    }

    VisitPlan plan(const std::vector<PlanTarget>& targets, const WaypointSettings& settings = {}) const {
        Progress progress;
        return planVisits(targets, collision, sight, robot_map, settings, {}, progress);
    }
    Waypoint only(const PlanTarget& target) const { return plan({target}).waypoints.front(); }

    CostMap collision;
    CostMap sight;
    Pose2 robot_map;
};

void block(OccupancyGrid& grid, int firstColumn, int lastColumn, int firstRow, int lastRow) {
    for (int row = firstRow; row <= lastRow; ++row) {
        for (int column = firstColumn; column <= lastColumn; ++column) {
            grid.cells[grid.offset({column, row})] = Cell::Occupied;
        }
    }
}

TEST(Waypoints, onOpenFloorStandsOnTheRingAndFacesTheCandidate) {
    const Waypoint waypoint = Room(walledRoom(80, 80)).only(targetAt(2.0, 2.0));
    ASSERT_EQ(waypoint.status, WaypointStatus::Ok);
    EXPECT_EQ(waypoint.id, "W-01");
    EXPECT_EQ(waypoint.candidateIds, std::vector<std::string>{"C-001"});
    // All poses cost nothing here, so the tie goes to the smallest angle and distance.
    // 0.5 m from the edge of the candidate, which ends 0.1 m from its centroid.
    EXPECT_NEAR(waypoint.pose_map->x_m, 2.6, 1e-9);
    EXPECT_NEAR(waypoint.pose_map->y_m, 2.0, 1e-9);
    EXPECT_NEAR(std::abs(waypoint.pose_map->yaw_rad), std::numbers::pi, 1e-9);
    EXPECT_EQ(waypoint.cost, 0.0);
}

TEST(Waypoints, takesTheLeastCostOfAllPosesThatBruteForceAllows) {
    OccupancyGrid grid = walledRoom(80, 80);
    block(grid, 28, 34, 44, 46);
    block(grid, 47, 48, 30, 38);
    const Room room(grid);
    const PlanTarget target = targetAt(2.02, 1.93);
    const Waypoint waypoint = room.only(target);
    ASSERT_TRUE(waypoint.pose_map);
    double least = std::numeric_limits<double>::infinity();
    for (int angle = 0; angle < 72; ++angle) {
        for (double distance = 0.5; distance < 0.76; distance += 0.05) {
            const Eigen::Vector2d direction(std::cos(angle * 5 / kDegreesPerRadian),
                                            std::sin(angle * 5 / kDegreesPerRadian));
            // So far from the rectangle of 0.2 × 0.1 m, found by walking away from its centre.
            double away = 0.0;
            const auto gap = [&](double at) {
                const Eigen::Vector2d beside(std::max(0.0, std::abs(at * direction.x()) - 0.1),
                                             std::max(0.0, std::abs(at * direction.y()) - 0.05));
                return beside.norm();
            };
            for (double step = 0.1; step > 1e-12; step *= 0.5)
                while (gap(away + step) < distance)
                    away += step;
            const Eigen::Vector2d place = target.centroid_map.head<2>() + away * direction;
            const CellIndex cell = grid.cellAt(place);
            if (!room.collision.isReachable(cell) || costPercent(room.collision.costAt(cell)) >= 85) continue;
            double cost = 0.0;
            bool blocked = false;
            // Quarter cells, up to one cell before half the width.
            for (int step = 0; step * 0.0125 <= away - 0.05 - 0.05 + 1e-9 && !blocked; ++step) {
                const Eigen::Vector2d at = place + step * 0.0125 * (target.centroid_map.head<2>() - place).normalized();
                const int here = room.sight.costAt(grid.cellAt(at));
                blocked = here == 254;
                cost += here;
            }
            if (!blocked) least = std::min(least, cost);
        }
    }
    EXPECT_EQ(waypoint.cost, least);
}

TEST(Waypoints, everyPoseIsReachableClearAndSeesItsCandidate) {
    OccupancyGrid grid = walledRoom(100, 80);
    block(grid, 40, 42, 0, 40);
    block(grid, 70, 71, 30, 79);
    const Room room(grid);
    std::vector<PlanTarget> targets;
    for (int i = 0; i < 40; ++i) {
        targets.push_back(targetAt(0.15 + 4.7 * (i % 8) / 7.0, 0.15 + 3.7 * (i / 8) / 4.0, "C-" + std::to_string(i)));
    }
    int found = 0;
    for (const Waypoint& waypoint : room.plan(targets).waypoints) {
        if (!waypoint.pose_map) continue;
        ++found;
        const Eigen::Vector2d place(waypoint.pose_map->x_m, waypoint.pose_map->y_m);
        EXPECT_TRUE(room.collision.isReachable(grid.cellAt(place)));
        EXPECT_LT(costPercent(room.collision.costAt(grid.cellAt(place))), 85.0);
        for (const std::string& id : waypoint.candidateIds) {
            const auto target = std::ranges::find(targets, id, &PlanTarget::candidateId);
            EXPECT_TRUE(SearchFloor(room.collision, room.sight, {}, {}).costOfSight(place, wholeOf(*target, 0)));
            const Transform T_camera_from_map = cameraPose(*waypoint.pose_map, {}).inverse();
            for (const double x : {-0.1, 0.1}) {
                for (const double y : {-0.05, 0.05}) {
                    for (const double z : {-0.05, 0.05}) {
                        const Eigen::Vector3d corner = target->centroid_map + Eigen::Vector3d(x, y, z);
                        const Eigen::Vector3d seen = T_camera_from_map * corner;
                        EXPECT_GT(seen.z(), 0.15);
                        EXPECT_TRUE(
                            isInImage(pixelOf(seen, intrinsicsOf(CameraSettings())), intrinsicsOf(CameraSettings())));
                    }
                }
            }
        }
    }
    EXPECT_GT(found, 5);
}

TEST(Waypoints, doesNotLookThroughAWall) {
    OccupancyGrid grid = walledRoom(80, 80);
    // A screen right of the candidate, where the tie would otherwise put the pose.
    block(grid, 46, 46, 30, 50);
    const Waypoint waypoint = Room(grid).only(targetAt(2.0, 2.0));
    ASSERT_TRUE(waypoint.pose_map);
    EXPECT_LT(waypoint.pose_map->x_m, 2.2);
}

TEST(Waypoints, aCandidateIsNoObstacleToItsOwnSight) {
    OccupancyGrid grid = walledRoom(80, 80);
    block(grid, 38, 42, 38, 42);
    Room room(grid);
    std::vector<Eigen::Vector3d> discrepant;
    for (double x = 1.91; x < 2.15; x += 0.02) {
        for (double y = 1.91; y < 2.15; y += 0.02)
            discrepant.emplace_back(x, y, 0.2);
    }
    const PlanTarget target = targetAt(2.02, 2.02);
    EXPECT_EQ(room.only(target).status, WaypointStatus::Hidden) << "with the candidate itself in the sight map";
    room.sight = inflate(withoutCandidates(grid, discrepant), {});
    EXPECT_EQ(room.only(target).status, WaypointStatus::Ok);
}

TEST(Waypoints, aCandidateLeaningOnAWallIsPhotographedFromTheOpenSide) {
    const Room room(walledRoom(80, 80));
    // The centroid lies inside the wall's cells, y < 0.05.
    const Waypoint waypoint = room.only(targetAt(2.0, 0.04));
    ASSERT_EQ(waypoint.status, WaypointStatus::Ok);
    EXPECT_GT(waypoint.pose_map->y_m, 0.3);
}

TEST(Waypoints, theRingWidensWhenTheNearPosesCollide) {
    OccupancyGrid grid = walledRoom(80, 80);
    // Posts round the candidate: nothing within 0.75 m of its edge is clear, but one can look between them.
    for (int i = 0; i < 20; ++i) {
        const double angle = i * std::numbers::pi / 10.0;
        const CellIndex post = grid.cellAt({2.0 + 0.72 * std::cos(angle), 2.0 + 0.72 * std::sin(angle)});
        grid.cells[grid.offset(post)] = Cell::Occupied;
    }
    const Waypoint waypoint = Room(grid).only(targetAt(2.0, 2.0));
    ASSERT_EQ(waypoint.status, WaypointStatus::Ok);
    EXPECT_GT(std::hypot(waypoint.pose_map->x_m - 2.0, waypoint.pose_map->y_m - 2.0), 0.85);
    WaypointSettings once;
    once.maximumTries = 1;
    EXPECT_EQ(Room(grid).plan({targetAt(2.0, 2.0)}, once).waypoints.front().status, WaypointStatus::TooCloseToWall);
}

TEST(Waypoints, tellWhyThereIsNone) {
    OccupancyGrid grid = walledRoom(200, 80);
    block(grid, 80, 80, 0, 79);
    const Room room(grid);
    EXPECT_EQ(room.only(targetAt(-8.0, 2.0)).status, WaypointStatus::OutsideGrid);
    EXPECT_EQ(room.only(targetAt(7.0, 2.0)).status, WaypointStatus::Unreachable) << "behind the wall";
    EXPECT_EQ(room.only(targetAt(std::nan(""), 2.0)).status, WaypointStatus::OutsideGrid);
    EXPECT_EQ(room.only(targetAt(1e300, 2.0)).status, WaypointStatus::OutsideGrid);

    OccupancyGrid crowded = walledRoom(80, 80);
    for (int row = 20; row < 80; row += 6) {
        for (int column = 20; column < 80; column += 6)
            block(crowded, column, column, row, row);
    }
    EXPECT_EQ(Room(crowded, {0.5, 0.5, 0.0}).only(targetAt(3.5, 3.5)).status, WaypointStatus::TooCloseToWall);

    OccupancyGrid box = walledRoom(80, 80);
    block(box, 36, 44, 36, 44);
    block(box, 38, 42, 38, 42);
    EXPECT_EQ(Room(box).only(targetAt(2.02, 2.02)).status, WaypointStatus::Hidden);
    EXPECT_EQ(toString(WaypointStatus::TooCloseToWall), "too close to a wall");
}

TEST(Waypoints, whatStandsInAnotherCompartmentIsUnreachableNotHidden) {
    OccupancyGrid grid = walledRoom(200, 80);
    block(grid, 80, 80, 0, 79);
    const Room room(grid);
    // 0.95 m behind the bulkhead: the widest rings reach over it to floor that the robot can drive on.
    EXPECT_EQ(room.only(targetAt(5.0, 2.0)).status, WaypointStatus::Unreachable);
    // Boxed in there, it is seen from nowhere.
    block(grid, 96, 104, 36, 44);
    block(grid, 98, 102, 38, 42);
    EXPECT_EQ(Room(grid).only(targetAt(5.02, 2.02)).status, WaypointStatus::Hidden);
}

TEST(Waypoints, aCandidateAtTheRobotsPlaceIsSeenFromBeside) {
    const Waypoint waypoint = Room(walledRoom(80, 80)).only(targetAt(1.0, 1.0));
    ASSERT_EQ(waypoint.status, WaypointStatus::Ok);
    EXPECT_GE(std::hypot(waypoint.pose_map->x_m - 1.0, waypoint.pose_map->y_m - 1.0), 0.42);
}

TEST(Waypoints, unknownFloorIsNoPlaceToStand) {
    OccupancyGrid grid = walledRoom(80, 80);
    for (int row = 30; row < 79; ++row) {
        for (int column = 1; column < 79; ++column)
            grid.cells[grid.offset({column, row})] = Cell::Unknown;
    }
    EXPECT_EQ(Room(grid).only(targetAt(2.0, 3.6)).status, WaypointStatus::Unreachable);
    const Waypoint edge = Room(grid).only(targetAt(2.0, 1.6));
    ASSERT_TRUE(edge.pose_map);
    EXPECT_LT(edge.pose_map->y_m, 1.5);
}

TEST(Waypoints, visitsTheNearestNextByTravelNotByAir) {
    OccupancyGrid grid = walledRoom(120, 80);
    block(grid, 50, 51, 0, 65);
    const Room room(grid, {2.0, 0.6, 0.0});
    // B is 1.2 m off by air but behind the wall.
    const VisitPlan plan = room.plan({targetAt(3.4, 0.6, "B"), targetAt(0.7, 0.6, "A"), targetAt(-9.0, 0.0, "X")});
    ASSERT_EQ(plan.waypoints.size(), 3U);
    EXPECT_EQ(plan.waypoints[0].candidateIds.front(), "A");
    EXPECT_EQ(plan.waypoints[1].candidateIds.front(), "B");
    EXPECT_EQ(plan.waypoints[2].candidateIds.front(), "X");
    EXPECT_EQ(plan.waypoints[2].id, "W-03");
    EXPECT_FALSE(plan.waypoints[2].pose_map);
    EXPECT_NEAR(plan.length_m, plan.waypoints[0].drive.length_m + plan.waypoints[1].drive.length_m, 1e-12);
    EXPECT_GT(plan.waypoints[1].drive.length_m, 5.0);
    EXPECT_EQ(plan.waypoints[0].drive.points_map.front(), Eigen::Vector2d(2.0, 0.6));
    EXPECT_EQ(plan.waypoints[1].drive.points_map.front(), plan.waypoints[0].drive.points_map.back());
}

TEST(Waypoints, sameInputSamePlan) {
    OccupancyGrid grid = walledRoom(80, 80);
    block(grid, 30, 31, 20, 60);
    const std::vector<PlanTarget> targets{targetAt(1.0, 3.0, "A"), targetAt(3.0, 1.0, "B"), targetAt(3.2, 3.2, "C")};
    EXPECT_EQ(waypointsJson(Room(grid).plan(targets)), waypointsJson(Room(grid).plan(targets)));
}

TEST(Waypoints, noTargetsNoWaypoints) {
    const VisitPlan plan = Room(walledRoom(80, 80)).plan({});
    EXPECT_TRUE(plan.waypoints.empty());
    EXPECT_EQ(plan.length_m, 0.0);
}

TEST(Waypoints, refusesMapsThatDoNotBelongTogetherAndBadSettings) {
    Room room(walledRoom(80, 80));
    room.sight = inflate(walledRoom(81, 80), {});
    EXPECT_THROW(room.plan({targetAt(2.0, 2.0)}), Error);
    Room unfilled(walledRoom(80, 80));
    unfilled.collision.reachable.clear();
    EXPECT_THROW(unfilled.plan({targetAt(2.0, 2.0)}), Error);
    const Room good(walledRoom(80, 80));
    WaypointSettings settings;
    settings.angleStep_rad = 0.0;
    EXPECT_THROW(good.plan({targetAt(2.0, 2.0)}, settings), Error);
    settings = {};
    settings.minimumDistance_m = 1.0;
    EXPECT_THROW(good.plan({targetAt(2.0, 2.0)}, settings), Error);
    settings = {};
    settings.maximumDistance_m = std::nan("");
    EXPECT_THROW(good.plan({targetAt(2.0, 2.0)}, settings), Error);
}

TEST(Waypoints, canBeCancelled) {
    const Room room(walledRoom(80, 80));
    Progress progress;
    progress.cancel();
    const std::vector<PlanTarget> targets{targetAt(2.0, 2.0)};
    EXPECT_THROW(planVisits(targets, room.collision, room.sight, room.robot_map, {}, {}, progress), Cancelled);
}

TEST(WaypointsJson, followsTheFileContract) {
    VisitPlan plan;
    plan.length_m = 2.5;
    plan.waypoints.push_back(
        {"W-01", {"C-002", "C-003"}, Pose2{1.0, 2.0, std::numbers::pi / 2.0}, 12.0, WaypointStatus::Ok, {}});
    plan.waypoints.push_back({"W-02", {"C-001"}, std::nullopt, 0.0, WaypointStatus::Hidden, {}});
    const auto json = nlohmann::json::parse(waypointsJson(plan));
    EXPECT_EQ(json["schema"], "fodscope.waypoints/1");
    EXPECT_EQ(json["length_m"], 2.5);
    EXPECT_EQ(json["waypoints"][0]["id"], "W-01");
    EXPECT_EQ(json["waypoints"][0]["candidates"], (std::vector<std::string>{"C-002", "C-003"}));
    EXPECT_DOUBLE_EQ(json["waypoints"][0]["pose_map"]["yaw_deg"], 90.0);
    EXPECT_EQ(json["waypoints"][0]["pose_map"]["x"], 1.0);
    EXPECT_EQ(json["waypoints"][0]["cost"], 12.0);
    EXPECT_EQ(json["waypoints"][0]["status"], "ok");
    EXPECT_TRUE(json["waypoints"][1]["pose_map"].is_null());
    EXPECT_TRUE(json["waypoints"][1]["cost"].is_null());
    EXPECT_EQ(json["waypoints"][1]["status"], "hidden");
}

}  // namespace
}  // namespace fodscope
