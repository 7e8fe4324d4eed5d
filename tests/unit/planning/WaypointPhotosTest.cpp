// SPDX-License-Identifier: MIT
// What the photos of a plan show: whole candidates, large ones in parts, several at once, and why some are not shown.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/planning/Waypoints.h"
#include "tests/fakes/PictureGrid.h"

namespace fodscope {
namespace {

struct Room {
    explicit Room(const OccupancyGrid& grid, const Pose2& robot = {1.0, 1.0, 0.0})
        : collision(inflate(grid, {})), sight(collision), robot_map(robot) {
        floodFill(collision, robot_map);
    }

    VisitPlan plan(const std::vector<PlanTarget>& targets, const WaypointSettings& settings = {}) const {
        Progress progress;
        return planVisits(targets, collision, sight, robot_map, settings, {}, progress);
    }

    CostMap collision;
    CostMap sight;
    Pose2 robot_map;
};

/// A box of voxels between two corners, as a detection finds it.
PlanTarget thing(const std::string& id, const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    PlanTarget target{id, 0.5 * (low + high), high - low, 0.0, {}, 0.02};
    for (double x = low.x() + 0.01; x < high.x(); x += 0.02)
        for (double y = low.y() + 0.01; y < high.y(); y += 0.02)
            for (double z = low.z() + 0.01; z < high.z(); z += 0.02)
                target.voxels.emplace_back(x, y, z);
    return target;
}

PlanTarget smallThing(const std::string& id, double x_m, double y_m, double z_m = 0.0) {
    return thing(id, {x_m - 0.05, y_m - 0.05, z_m}, {x_m + 0.05, y_m + 0.05, z_m + 0.08});
}

bool shows(const Pose2& pose, const Eigen::Vector3d& point) {
    const CameraIntrinsics k = intrinsicsOf(CameraSettings());
    const Eigen::Vector3d seen = cameraPose(pose, CameraSettings()).inverse() * point;
    return seen.z() > 0.15 && isInImage(pixelOf(seen, k), k) && seen.norm() / k.fx_px <= 0.0015;
}

bool holds(const Waypoint& waypoint, const std::string& id) {
    return std::ranges::find(waypoint.candidateIds, id) != waypoint.candidateIds.end();
}

std::size_t photosOf(const VisitPlan& plan) {
    return static_cast<std::size_t>(
        std::ranges::count_if(plan.waypoints, [](const Waypoint& waypoint) { return waypoint.pose_map.has_value(); }));
}

/// Voxels that some photo shows which was taken for their candidate.
std::size_t shownVoxels(const VisitPlan& plan, const PlanTarget& target) {
    return static_cast<std::size_t>(std::ranges::count_if(target.voxels, [&](const Eigen::Vector3d& voxel) {
        return std::ranges::any_of(plan.waypoints, [&](const Waypoint& waypoint) {
            return waypoint.pose_map && holds(waypoint, target.candidateId) && shows(*waypoint.pose_map, voxel);
        });
    }));
}

TEST(WaypointPhotos, theRingBeginsAtTheEdgeOfTheCandidate) {
    const PlanTarget bar = thing("C-001", {1.4, 2.4, 0.0}, {2.6, 2.44, 0.04});
    const VisitPlan plan = Room(walledRoom(120, 100)).plan({bar});
    ASSERT_GE(photosOf(plan), 1U);
    for (const Waypoint& waypoint : plan.waypoints) {
        for (const Eigen::Vector3d& voxel : bar.voxels)
            EXPECT_GT(std::hypot(voxel.x() - waypoint.pose_map->x_m, voxel.y() - waypoint.pose_map->y_m), 0.25);
    }
}

TEST(WaypointPhotos, aLargeCandidateIsShownInSeveralThatTogetherShowAllOfIt) {
    const PlanTarget beam = thing("C-001", {1.0, 2.0, 0.0}, {4.2, 2.06, 0.06});
    const VisitPlan plan = Room(walledRoom(110, 90)).plan({beam});
    EXPECT_GE(photosOf(plan), 3U);
    EXPECT_LE(photosOf(plan), 6U);
    EXPECT_EQ(shownVoxels(plan, beam), beam.voxels.size());
    ASSERT_EQ(plan.views.size(), 1U);
    EXPECT_EQ(plan.views[0], (CandidateView{"C-001", 1.0, WaypointStatus::Ok}));
}

TEST(WaypointPhotos, onePhotoServesCandidatesThatFitIntoItTogether) {
    const std::vector<PlanTarget> targets{smallThing("A", 2.0, 2.0), smallThing("B", 2.25, 2.1),
                                          smallThing("C", 2.0, 2.3), smallThing("D", 3.4, 0.6)};
    const VisitPlan plan = Room(walledRoom(90, 80)).plan(targets);
    EXPECT_EQ(photosOf(plan), 2U);
    for (const PlanTarget& target : targets)
        EXPECT_EQ(shownVoxels(plan, target), target.voxels.size()) << target.candidateId;
    EXPECT_TRUE(std::ranges::any_of(plan.waypoints, [](const Waypoint& waypoint) {
        return waypoint.candidateIds == std::vector<std::string>{"A", "B", "C"};
    }));
}

TEST(WaypointPhotos, noPhotoServesTwoSidesOfAWall) {
    OccupancyGrid grid = walledRoom(90, 80);
    for (int row = 0; row < 60; ++row)
        grid.cells[grid.offset({44, row})] = Cell::Occupied;
    const VisitPlan plan = Room(grid).plan({smallThing("A", 2.0, 1.5), smallThing("B", 2.45, 1.5)});
    EXPECT_EQ(photosOf(plan), 2U);
}

TEST(WaypointPhotos, aCandidateBehindAnotherHasAPhotoOfItsOwn) {
    // A cabinet of 0.4 m, and something small at its back: from the front one hides the other.
    OccupancyGrid grid = walledRoom(90, 80);
    const PlanTarget cabinet = thing("A", {2.0, 2.0, 0.0}, {2.3, 2.3, 0.4});
    const PlanTarget bolt = thing("B", {2.34, 2.1, 0.0}, {2.4, 2.16, 0.04});
    const VisitPlan plan = Room(grid).plan({cabinet, bolt});
    for (const Waypoint& waypoint : plan.waypoints) {
        if (!holds(waypoint, "B") || !holds(waypoint, "A")) continue;
        EXPECT_GT(waypoint.pose_map->x_m + std::abs(waypoint.pose_map->y_m - 2.13), 2.3) << "not through the cabinet";
    }
    EXPECT_EQ(plan.views[1].share, 1.0);
}

TEST(WaypointPhotos, noPoseIsOnAnotherCandidate) {
    // Scrap all over the floor round the thing but for one side.
    std::vector<PlanTarget> targets{smallThing("A", 2.0, 2.0)};
    PlanTarget scrap = thing("B", {2.4, 1.2, 0.0}, {3.2, 2.8, 0.02});
    targets.push_back(scrap);
    const VisitPlan plan = Room(walledRoom(90, 80)).plan(targets);
    for (const Waypoint& waypoint : plan.waypoints) {
        if (!waypoint.pose_map) continue;
        for (const Eigen::Vector3d& voxel : scrap.voxels)
            EXPECT_GT(std::hypot(voxel.x() - waypoint.pose_map->x_m, voxel.y() - waypoint.pose_map->y_m), 0.2);
    }
}

TEST(WaypointPhotos, whatIsHighOnAWallIsToldToBeTooHighForTheCamera) {
    const VisitPlan plan = Room(walledRoom(90, 80)).plan({smallThing("A", 2.0, 0.1, 1.4)});
    EXPECT_EQ(photosOf(plan), 0U);
    ASSERT_EQ(plan.waypoints.size(), 1U);
    EXPECT_EQ(plan.waypoints[0].status, WaypointStatus::TooHigh);
    EXPECT_EQ(toString(plan.waypoints[0].status), "too high for the camera");
    EXPECT_EQ(plan.views[0].share, 0.0);
}

TEST(WaypointPhotos, ofAThingThatRisesOutOfThePictureTheLowerPartIsShownAndTheRestTold) {
    const PlanTarget hose = thing("A", {2.0, 0.06, 0.0}, {2.06, 0.1, 1.6});
    const VisitPlan plan = Room(walledRoom(90, 80)).plan({hose});
    EXPECT_GE(photosOf(plan), 1U);
    ASSERT_EQ(plan.views.size(), 1U);
    EXPECT_GT(plan.views[0].share, 0.2);
    EXPECT_LT(plan.views[0].share, 0.6);
    EXPECT_EQ(plan.views[0].rest, WaypointStatus::TooHigh);
    EXPECT_GE(shownVoxels(plan, hose),
              static_cast<std::size_t>(plan.views[0].share * static_cast<double>(hose.voxels.size())) - 1);
    EXPECT_EQ(plan.waypoints.size(), photosOf(plan)) << "it is in no waypoint without a pose";
}

TEST(WaypointPhotos, aCameraThatSeesLittleSaysSo) {
    const Room room(walledRoom(40, 40), {1.0, 1.0, 0.0});
    Progress progress;
    const std::vector<PlanTarget> target{smallThing("A", 1.0, 1.0)};
    CameraSettings coarse;
    coarse.width_px = 64;
    coarse.height_px = 36;
    const auto far = planVisits(target, room.collision, room.sight, room.robot_map, {}, coarse, progress);
    EXPECT_EQ(far.waypoints[0].status, WaypointStatus::TooFar);
    CameraSettings narrow;
    narrow.horizontalFieldOfView_rad = radiansFromDegrees(4.0);
    WaypointSettings ring;
    ring.maximumTries = 1;
    const auto near = planVisits(target, room.collision, room.sight, room.robot_map, ring, narrow, progress);
    EXPECT_EQ(near.waypoints[0].status, WaypointStatus::TooNear);
}

TEST(WaypointPhotos, theOrderIsChosenAndBothLengthsAreTold) {
    const Room room(walledRoom(200, 60), {4.0, 1.5, 0.0});
    std::vector<PlanTarget> targets;
    for (const double x : {1.0, 3.2, 5.2, 6.9, 8.9})
        targets.push_back(smallThing("C-" + std::to_string(targets.size()), x, 1.5));
    WaypointSettings nearest;
    nearest.order = VisitOrder::NearestNext;
    const VisitPlan paper = room.plan(targets, nearest), shortest = room.plan(targets);
    EXPECT_NEAR(paper.length_m, *paper.nearestNextLength_m, 1e-9);
    EXPECT_NEAR(shortest.length_m, *shortest.shortestTourLength_m, 1e-9);
    EXPECT_EQ(paper.nearestNextLength_m, shortest.nearestNextLength_m);
    EXPECT_EQ(paper.shortestTourLength_m, shortest.shortestTourLength_m);
    EXPECT_LE(shortest.length_m, paper.length_m);
    double sum_m = 0.0;
    for (const Waypoint& waypoint : shortest.waypoints)
        sum_m += waypoint.drive.length_m;
    EXPECT_NEAR(sum_m, shortest.length_m, 1e-9);
}

}  // namespace
}  // namespace fodscope
