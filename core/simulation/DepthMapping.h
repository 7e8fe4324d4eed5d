// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
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
    double driftXy_m = 0.006;
    double driftYaw_rad = 0.004;
    double driftZ_m = 0.002;
    /// Distance between two key frames along the route.
    double keyFrameSpacing_m = 0.08;
    /// Voxels of the map that comes out.
    double mapVoxel_m = 0.01;
    std::uint64_t seed = 1;
};

/// What one mapping run brings.
struct MappingRun {
    /// Map frame: the world moved by `T_map_from_world`.
    PointCloud map;
    Transform T_map_from_world = Transform::Identity();
    std::vector<Transform> trajectory_map;
    OccupancyGrid grid_map;
    Pose2 robotStart_map;
    /// Points on each object of the world.
    std::vector<std::size_t> pointsOnObject;
    /// Mean of the points on each object; NaN where there are none.
    std::vector<Eigen::Vector3d> observedCentroid_map;
};

/// Drives a closed route over the reachable floor and merges the depth images. Seeded; runs in parallel without
/// changing the result.
MappingRun mapWorld(const World& world, const DepthMappingSettings& settings, Progress& progress);

}  // namespace fodscope
