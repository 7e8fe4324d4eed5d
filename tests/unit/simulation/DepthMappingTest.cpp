// SPDX-License-Identifier: MIT
#include "core/simulation/DepthMapping.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cmath>

#include "SmallWorlds.h"
#include "core/common/Error.h"
#include "core/simulation/BuiltinDemo.h"
#include "core/simulation/FloorGrid.h"
#include "core/simulation/Raycaster.h"
#include "core/simulation/Route.h"

namespace fodscope {
namespace {

/// Few and small images: enough for what is tested.
DepthMappingSettings coarse() {
    DepthMappingSettings settings;
    settings.columns = 64;
    settings.rows = 36;
    settings.keyFrameSpacing_m = 0.2;
    settings.lookSpacing_m = 1.2;
    return settings;
}

World furnishedRoom() {
    World world = test::room();
    world.objects.push_back(test::boxObject({2.2, 1.3, 0.0}, {2.4, 1.5, 0.12}));
    world.objects.push_back(test::boxObject({5.0, 5.0, 0.0}, {5.2, 5.2, 0.1}));
    return world;
}

TEST(FloorGrid, FindsFloorWallsAndThinPlates) {
    World world = test::room();
    // A sheet without thickness, standing across half of the room.
    append(world.structure, quadMesh({1.02, 0.0, 0.0}, {1.02, 1.0, 0.0}, {1.02, 1.0, 1.0}, {1.02, 0.0, 1.0}, {}));
    // Low enough to be crossed.
    append(world.structure, boxMesh({2.0, 0.0, 0.0}, {2.1, 2.0, 0.05}, {}));
    const OccupancyGrid grid = floorGrid(world, Raycaster(world), Transform::Identity(), {});
    EXPECT_EQ(grid.at(grid.cellAt({0.5, 0.5})), Cell::Free);
    EXPECT_EQ(grid.at(grid.cellAt({2.05, 0.5})), Cell::Free);
    EXPECT_EQ(grid.at(grid.cellAt({1.02, 0.5})), Cell::Occupied);
    EXPECT_EQ(grid.at(grid.cellAt({1.02, 1.5})), Cell::Free);
    EXPECT_EQ(grid.at(grid.cellAt({0.0, 1.0})), Cell::Occupied);
    EXPECT_EQ(grid.at(grid.cellAt({-0.08, 1.0})), Cell::Unknown);
}

TEST(FloorGrid, WhatCannotBeExploredStaysUnknown) {
    World world = test::room();
    // A closed pillar, hollow, and floor that goes on behind the wall.
    append(world.structure, cylinderMesh({2.0, 1.0, -0.01}, {2.0, 1.0, 1.0}, 0.3, {}));
    append(world.structure, boxMesh({3.0, 0.0, -0.05}, {4.0, 2.0, 0.0}, {}));
    const OccupancyGrid all = floorGrid(world, Raycaster(world), Transform::Identity(), {});
    EXPECT_EQ(all.at(all.cellAt({3.5, 1.0})), Cell::Free);
    const OccupancyGrid grid = explored(all, world.robotStart_world);
    EXPECT_EQ(grid.at(grid.cellAt({0.5, 0.5})), Cell::Free);
    EXPECT_EQ(grid.at(grid.cellAt({1.7, 1.0})), Cell::Occupied);
    EXPECT_EQ(grid.at(grid.cellAt({2.02, 1.02})), Cell::Unknown);
    EXPECT_EQ(grid.at(grid.cellAt({3.5, 1.0})), Cell::Unknown);
}

TEST(Route, ComesByAllReachableFloorAndReturns) {
    const World world = furnishedRoom();
    const OccupancyGrid grid = floorGrid(test::room(), Raycaster(test::room()), Transform::Identity(), {});
    RouteSettings settings;
    const std::vector<Pose2> route = mappingRoute(grid, world.robotStart_world, settings);
    ASSERT_GT(route.size(), 10u);
    EXPECT_EQ(route.front(), world.robotStart_world);
    EXPECT_NEAR(route.back().x_m, world.robotStart_world.x_m, 0.05);
    EXPECT_NEAR(route.back().y_m, world.robotStart_world.y_m, 0.05);
    for (std::size_t i = 1; i < route.size(); ++i) {
        const double step = std::hypot(route[i].x_m - route[i - 1].x_m, route[i].y_m - route[i - 1].y_m);
        EXPECT_LE(step, settings.keyFrameSpacing_m + 1e-9);
        EXPECT_LE(std::abs(wrapAngle(route[i].yaw_rad - route[i - 1].yaw_rad)), settings.keyFrameTurn_rad + 1e-9);
        EXPECT_EQ(grid.at(grid.cellAt({route[i].x_m, route[i].y_m})), Cell::Free);
    }
    for (double x = 0.3; x < 2.8; x += 0.1)
        for (double y = 0.3; y < 1.8; y += 0.1)
            EXPECT_TRUE(std::any_of(route.begin(), route.end(),
                                    [&](const Pose2& pose) { return std::hypot(pose.x_m - x, pose.y_m - y) < 1.0; }))
                << x << " " << y;
}

TEST(Route, AStartOffTheFloorIsRefused) {
    const OccupancyGrid grid = floorGrid(test::room(), Raycaster(test::room()), Transform::Identity(), {});
    EXPECT_THROW(mappingRoute(grid, {10.0, 10.0, 0.0}, {}), Error);
}

TEST(DepthMapping, MapPointsLieNearTheSurfaces) {
    const World world = furnishedRoom();
    Progress progress;
    const MappingRun run = mapWorld(world, coarse(), progress);
    ASSERT_GT(run.map.size(), 5000u);
    ASSERT_EQ(run.map.colours.size(), run.map.size());
    const Transform T_world_from_map = run.T_map_from_world.inverse();
    std::vector<double> distances;
    for (const Eigen::Vector3d& point_map : run.map.points) {
        const Eigen::Vector3d p = T_world_from_map * point_map;
        const double walls = std::min({std::abs(p.x()), std::abs(3.0 - p.x()), std::abs(p.y()), std::abs(2.0 - p.y()),
                                       std::abs(p.z()), std::abs(1.0 - p.z())});
        const Eigen::AlignedBox3d box(Eigen::Vector3d(2.2, 1.3, 0.0), Eigen::Vector3d(2.4, 1.5, 0.12));
        distances.push_back(std::min(walls, box.exteriorDistance(p)));
        EXPECT_LE(point_map.z(), coarse().mapMaximumHeight_m);
    }
    std::sort(distances.begin(), distances.end());
    const auto percentile = [&](double share) {
        return distances[static_cast<std::size_t>(share * static_cast<double>(distances.size() - 1))];
    };
    // Drift 6 mm and 0.23 degrees, depth noise up to 12 mm and steps of 35 mm at the far end.
    EXPECT_LT(percentile(0.50), 0.015);
    EXPECT_LT(percentile(0.95), 0.06);
    EXPECT_GT(percentile(0.50), 0.001) << "a perfect map is no depth camera's";
}

TEST(DepthMapping, TellsWhatWasSeenOfEachObject) {
    const World world = furnishedRoom();
    Progress progress;
    const MappingRun run = mapWorld(world, coarse(), progress);
    ASSERT_EQ(run.pointsOnObject.size(), 2u);
    EXPECT_GT(run.pointsOnObject[0], 50u);
    const Eigen::Vector3d centre_map = run.T_map_from_world * Eigen::Vector3d(2.3, 1.4, 0.06);
    EXPECT_LT((run.observedCentroid_map[0] - centre_map).norm(), 0.15);
    EXPECT_EQ(run.pointsOnObject[1], 0u);
    EXPECT_TRUE(run.observedCentroid_map[1].array().isNaN().all()) << "not observed is not known";
}

TEST(DepthMapping, TheMapFrameIsOffTheWorldByALittle) {
    const World world = furnishedRoom();
    Progress progress;
    const MappingRun run = mapWorld(world, coarse(), progress);
    const double offset = run.T_map_from_world.translation().norm();
    const double angle = Eigen::AngleAxisd(run.T_map_from_world.linear()).angle();
    EXPECT_GT(offset, 1e-4);
    EXPECT_LT(offset, 0.12);
    EXPECT_GT(angle, 1e-4);
    EXPECT_LT(angle, 0.05);
    const Pose2 start = poseFromTransform(run.T_map_from_world * transformFromPose(world.robotStart_world));
    EXPECT_NEAR(run.robotStart_map.x_m, start.x_m, 1e-9);
    EXPECT_EQ(run.grid_map.at(run.grid_map.cellAt({start.x_m, start.y_m})), Cell::Free);
    ASSERT_EQ(run.trajectory_map.size(), run.trajectory_world.size());
    for (std::size_t i = 0; i < run.trajectory_map.size(); ++i)
        EXPECT_LT((run.T_map_from_world.inverse() * run.trajectory_map[i].translation() -
                   run.trajectory_world[i].translation())
                      .norm(),
                  0.05);
}

TEST(DepthMapping, TheSameSeedGivesTheSameMapWithAnyNumberOfThreads) {
    const World world = furnishedRoom();
    std::vector<MappingRun> runs;
    for (const std::size_t threads : {1, 2}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        Progress progress;
        runs.push_back(mapWorld(world, coarse(), progress));
    }
    EXPECT_EQ(runs[0].map.points, runs[1].map.points);
    EXPECT_EQ(runs[0].map.colours, runs[1].map.colours);
    EXPECT_EQ(runs[0].pointsOnObject, runs[1].pointsOnObject);
    EXPECT_EQ(runs[0].grid_map.cells, runs[1].grid_map.cells);
    DepthMappingSettings other = coarse();
    other.seed = 2;
    Progress progress;
    EXPECT_NE(runs[0].map.points, mapWorld(world, other, progress).map.points);
}

TEST(DepthMapping, KeepsAtMostThePointsAskedFor) {
    DepthMappingSettings settings = coarse();
    settings.mapMaximumPoints = 1000;
    Progress progress;
    const MappingRun run = mapWorld(test::room(), settings, progress);
    EXPECT_EQ(run.map.size(), 1000u);
    EXPECT_GT(run.voxels, 1000u);
}

TEST(DepthMapping, CanBeCancelled) {
    Progress progress;
    progress.cancel();
    EXPECT_THROW(mapWorld(test::room(), coarse(), progress), Cancelled);
    int reports = 0;
    Progress* running = nullptr;
    Progress midway([&](const std::string&, double) {
        if (++reports == 2) running->cancel();
    });
    running = &midway;
    EXPECT_THROW(mapWorld(test::room(), coarse(), midway), Cancelled);
}

TEST(DepthMapping, ImpossibleSettingsAreRefused) {
    Progress progress;
    DepthMappingSettings settings = coarse();
    settings.columns = 0;
    EXPECT_THROW(mapWorld(test::room(), settings, progress), Error);
    settings = coarse();
    settings.maximumRange_m = 0.1;
    EXPECT_THROW(mapWorld(test::room(), settings, progress), Error);
    settings = coarse();
    settings.keyFrameSpacing_m = 0.0;
    EXPECT_THROW(mapWorld(test::room(), settings, progress), Error);
}

TEST(BuiltinTrials, BringNominalMapsAndATrialWithFodInIt) {
    BuiltinTrialsSettings settings;
    settings.nominalRuns = 2;
    settings.mapping.columns = 48;
    settings.mapping.rows = 27;
    settings.mapping.lookSpacing_m = 1.5;
    double last = 0.0;
    Progress progress([&](const std::string&, double fraction) {
        EXPECT_GE(fraction, last);
        last = fraction;
    });
    const BuiltinTrials trials = makeBuiltinTrials(settings, progress);
    EXPECT_NEAR(last, 1.0, 1e-9);
    ASSERT_EQ(trials.nominal.size(), 2u);
    EXPECT_TRUE(trials.nominal[0].pointsOnObject.empty());
    EXPECT_NE(trials.nominal[0].map.points, trials.nominal[1].map.points);
    ASSERT_GE(trials.world->objects.size(), 2u);
    EXPECT_EQ(trials.trial.pointsOnObject.size(), trials.world->objects.size());
    EXPECT_TRUE(trials.world->T_map_from_world.isApprox(trials.trial.T_map_from_world));
    EXPECT_FALSE(trials.cad.triangles.empty());
}

}  // namespace
}  // namespace fodscope
