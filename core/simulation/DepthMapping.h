// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/cloud/PointCloud.h"
#include "core/common/Progress.h"
#include "core/planning/OccupancyGrid.h"
#include "core/simulation/World.h"

namespace fodscope {

/// A depth camera like the RealSense D435 on a driving robot, and the drift of the SLAM behind it.
struct DepthMappingSettings {
    double horizontalFieldOfView_rad = 1.518;  // 87°
    double verticalFieldOfView_rad = 1.012;    // 58°
    int columns = 160;
    int rows = 90;
    double cameraHeight_m = 0.20;
    double pitchDown_rad = 0.0873;  // 5°
    double minimumRange_m = 0.3;
    double maximumRange_m = 2.5;
    /// Depth noise σ = this · z².
    double depthNoise_per_m = 0.002;
    /// Depth is measured in steps of disparity: disparity = focal length · baseline / z.
    double disparityFocal_px = 446.8;
    double disparityBaseline_m = 0.05;
    double disparityStep_px = 0.125;
    /// Share of the pixels at an edge that come out somewhere between its two sides.
    double flyingPixelShare = 0.35;
    /// Surfaces seen at less than this angle (between ray and surface) begin to drop out.
    double grazingAngle_rad = 0.2094;
    /// Standard deviations of the SLAM's error, an Ornstein-Uhlenbeck process along the way.
    double driftXy_m = 0.006;
    double driftYaw_rad = 0.004;
    double driftZ_m = 0.002;
    double driftRollPitch_rad = 0.0012;
    /// Way over which the error forgets itself.
    double driftLength_m = 2.5;
    /// The map frame lies where the SLAM began: this far from the world frame, at most.
    double frameOffset_m = 0.06;
    double frameYaw_rad = 0.035;
    double frameTilt_rad = 0.003;
    /// Distance between two key frames along the route.
    double keyFrameSpacing_m = 0.08;
    /// Distance between the places at which it turns round once.
    double lookSpacing_m = 0.7;
    /// Voxels of the map that comes out.
    double mapVoxel_m = 0.01;
    /// Heights over the floor that the map keeps.
    double mapMinimumHeight_m = -0.15;
    double mapMaximumHeight_m = 0.75;
    /// A random subset of the voxels, when there are more.
    std::size_t mapMaximumPoints = 260000;
    std::uint64_t seed = 1;
};

/// Where a SLAM that begins with these settings puts its map frame: drawn from the seed, the same each time.
/// @return T_map_from_world
Transform drawMapFrame(const DepthMappingSettings& settings);

/// What one mapping run brings.
struct MappingRun {
    /// Map frame: the world moved by `T_map_from_world`, which the run draws for itself.
    PointCloud map;
    Transform T_map_from_world = Transform::Identity();
    /// Camera body poses of the key frames (x forward, y left, z up), as the SLAM believes them.
    std::vector<Transform> trajectory_map;
    /// The same as they were.
    std::vector<Transform> trajectory_world;
    /// Depth returns behind the map, and voxels before the subset was drawn.
    std::size_t rawPoints = 0;
    std::size_t voxels = 0;
    /// True occupancy of what the robot could explore; unknown elsewhere.
    OccupancyGrid grid_map;
    Pose2 robotStart_map;
    /// Points of the map that are mostly returns of each object of the world.
    std::vector<std::size_t> pointsOnObject;
    /// Mean of the points on each object; NaN where there are none.
    std::vector<Eigen::Vector3d> observedCentroid_map;
};

/// Drives a closed route over the reachable floor and merges the depth images. Seeded; runs in parallel without
/// changing the result.
MappingRun mapWorld(const World& world, const DepthMappingSettings& settings, Progress& progress);

/// The same along a drive that somebody else made, and in the map frame of the world.
/// @param poses_world the robot's key frames
/// @throws Error as mapWorld(), and without key frames
MappingRun mapAlong(const World& world, std::span<const Pose2> poses_world, const DepthMappingSettings& settings,
                    Progress& progress);

}  // namespace fodscope
