// SPDX-License-Identifier: MIT
#include "core/simulation/DepthMapping.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/common/Error.h"
#include "core/simulation/DepthCamera.h"
#include "core/simulation/FloorGrid.h"
#include "core/simulation/MapVoxels.h"
#include "core/simulation/PhotoCamera.h"
#include "core/simulation/PoseDrift.h"
#include "core/simulation/Random.h"
#include "core/simulation/Route.h"
#include "core/simulation/RustyPaint.h"

namespace fodscope {
namespace {

constexpr const char* kStage = "simulating a mapping run";

void requireUsable(const DepthMappingSettings& s) {
    const auto require = [](bool holds, const char* what) {
        if (!holds) throw Error("depth camera", std::string(what) + " is out of range", "check the settings");
    };
    require(s.columns >= 2 && s.rows >= 2 && s.columns <= 4096 && s.rows <= 4096, "the image size");
    require(s.horizontalFieldOfView_rad > 0.0 && s.horizontalFieldOfView_rad < 3.0 && s.verticalFieldOfView_rad > 0.0 &&
                s.verticalFieldOfView_rad < 3.0,
            "the field of view");
    require(s.minimumRange_m >= 0.0 && s.maximumRange_m > s.minimumRange_m, "the range");
    require(s.keyFrameSpacing_m > 0.001 && s.lookSpacing_m >= 0.1, "the spacing of the key frames");
    require(s.mapVoxel_m >= 0.001, "the voxel size of the map");
    require(s.driftLength_m > 0.0 && s.depthNoise_per_m >= 0.0, "the noise");
}

/// x forward, y left, z up, at the camera.
Transform bodyPose(const Pose2& robot, const DepthMappingSettings& s) {
    Transform T_robot_from_body = Transform::Identity();
    T_robot_from_body.translation().z() = s.cameraHeight_m;
    T_robot_from_body.linear() = Eigen::AngleAxisd(s.pitchDown_rad, Eigen::Vector3d::UnitY()).toRotationMatrix();
    return transformFromPose(robot) * T_robot_from_body;
}

/// REP 103: the optical frame looks along z, its x is right.
Transform bodyFromOptical() {
    Transform T_body_from_optical = Transform::Identity();
    T_body_from_optical.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    return T_body_from_optical;
}

/// Frames are taken in parallel, in batches that bound the memory, and merged in order.
MapVoxels mergeFrames(const Raycaster& raycaster, const MappingRun& run, const DepthMappingSettings& settings,
                      std::size_t& rawPoints, Progress& progress) {
    constexpr std::size_t kBatch = 32;
    const Transform T_body_from_optical = bodyFromOptical();
    MapVoxels voxels(settings.mapVoxel_m);
    const std::size_t count = run.trajectory_world.size();
    std::vector<std::vector<DepthReturn>> frames;
    for (std::size_t begin = 0; begin < count; begin += kBatch) {
        progress.report(kStage, static_cast<double>(begin) / static_cast<double>(count));
        frames.assign(std::min(kBatch, count - begin), {});
        tbb::parallel_for(std::size_t{0}, frames.size(), [&](std::size_t i) {
            if (progress.isCancelled()) return;
            frames[i] = depthFrame(raycaster, run.trajectory_world[begin + i] * T_body_from_optical, settings,
                                   streamSeed(settings.seed, 1000 + begin + i));
        });
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const Transform T_map_from_optical = run.trajectory_map[begin + i] * T_body_from_optical;
            rawPoints += frames[i].size();
            for (const DepthReturn& one : frames[i])
                voxels.add(T_map_from_optical * one.point_camera.cast<double>(), one.colour, one.object);
        }
    }
    progress.throwIfCancelled();
    return voxels;
}

/// Drops what is too low or high, and draws the subset.
std::vector<MapVoxels::Voxel> keptVoxels(const MapVoxels& all, const DepthMappingSettings& settings,
                                         std::size_t& before) {
    std::vector<MapVoxels::Voxel> voxels = all.sorted();
    std::erase_if(voxels, [&](const MapVoxels::Voxel& voxel) {
        const double z = voxel.mean().z();
        return z < settings.mapMinimumHeight_m || z > settings.mapMaximumHeight_m;
    });
    before = voxels.size();
    if (voxels.size() <= settings.mapMaximumPoints) return voxels;
    // Selection sampling (Knuth, algorithm S): keeps the order and the exact number.
    Random random(streamSeed(settings.seed, 13));
    std::vector<MapVoxels::Voxel> kept;
    kept.reserve(settings.mapMaximumPoints);
    for (std::size_t i = 0; i < voxels.size(); ++i)
        if (random.below(voxels.size() - i) < settings.mapMaximumPoints - kept.size()) kept.push_back(voxels[i]);
    return kept;
}

Rgb mapColour(const MapVoxels::Voxel& voxel, const Transform& T_world_from_map) {
    if (voxel.object >= 0) return voxel.colour();
    const Eigen::Vector3f point_world = (T_world_from_map * voxel.mean()).cast<float>();
    const Finish finish = rustyPaint(point_world, Eigen::Vector3f::UnitZ(), voxel.colour());
    const auto channel = [&](int i) {
        return static_cast<std::uint8_t>(std::lround(255.0f * srgbFromLinear(finish.reflectance[i])));
    };
    return {channel(0), channel(1), channel(2)};
}

void fillMap(MappingRun& run, const std::vector<MapVoxels::Voxel>& voxels, std::size_t objects) {
    run.map.points.reserve(voxels.size());
    run.map.colours.resize(voxels.size());
    run.pointsOnObject.assign(objects, 0);
    run.observedCentroid_map.assign(objects, Eigen::Vector3d::Zero());
    for (const MapVoxels::Voxel& voxel : voxels) {
        run.map.points.push_back(voxel.mean());
        if (voxel.object < 0 || voxel.votes == 0) continue;
        const auto object = static_cast<std::size_t>(voxel.object);
        ++run.pointsOnObject[object];
        run.observedCentroid_map[object] += voxel.mean();
    }
    for (std::size_t i = 0; i < objects; ++i) {
        if (run.pointsOnObject[i] > 0)
            run.observedCentroid_map[i] /= static_cast<double>(run.pointsOnObject[i]);
        else
            run.observedCentroid_map[i].setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    const Transform T_world_from_map = run.T_map_from_world.inverse();
    tbb::parallel_for(std::size_t{0}, voxels.size(),
                      [&](std::size_t i) { run.map.colours[i] = mapColour(voxels[i], T_world_from_map); });
}

/// Everything but where it drives and where its map frame lies.
void mapTrajectory(MappingRun& run, const World& world, const Raycaster& raycaster, std::span<const Pose2> poses_world,
                   const DepthMappingSettings& settings, Progress& progress) {
    for (const Pose2& pose : poses_world)
        run.trajectory_world.push_back(bodyPose(pose, settings));
    for (const Transform& pose : withDrift(run.trajectory_world, settings))
        run.trajectory_map.push_back(run.T_map_from_world * pose);
    run.robotStart_map = poseFromTransform(run.T_map_from_world * transformFromPose(world.robotStart_world));
    run.grid_map = explored(floorGrid(world, raycaster, run.T_map_from_world, {}), run.robotStart_map);

    const MapVoxels voxels = mergeFrames(raycaster, run, settings, run.rawPoints, progress);
    fillMap(run, keptVoxels(voxels, settings, run.voxels), world.objects.size());
    progress.report(kStage, 1.0);
}

}  // namespace

Transform drawMapFrame(const DepthMappingSettings& s) {
    Random random(streamSeed(s.seed, 7));
    const auto within = [&](double most) { return most * random.uniform(-1.0, 1.0); };
    Transform T_map_from_world = Transform::Identity();
    const double x = within(s.frameOffset_m), y = within(s.frameOffset_m), z = 0.1 * within(s.frameOffset_m);
    const double roll = within(s.frameTilt_rad), pitch = within(s.frameTilt_rad), yaw = within(s.frameYaw_rad);
    T_map_from_world.translation() = Eigen::Vector3d(x, y, z);
    T_map_from_world.linear() =
        (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()))
            .toRotationMatrix();
    return T_map_from_world;
}

MappingRun mapWorld(const World& world, const DepthMappingSettings& settings, Progress& progress) {
    requireUsable(settings);
    progress.report(kStage, 0.0);
    const Raycaster raycaster(world);
    const OccupancyGrid grid_world = floorGrid(world, raycaster, Transform::Identity(), {});
    RouteSettings route;
    route.keyFrameSpacing_m = settings.keyFrameSpacing_m;
    route.lookSpacing_m = settings.lookSpacing_m;
    route.seed = settings.seed;

    MappingRun run;
    run.T_map_from_world = drawMapFrame(settings);
    mapTrajectory(run, world, raycaster, mappingRoute(grid_world, world.robotStart_world, route), settings, progress);
    return run;
}

MappingRun mapAlong(const World& world, std::span<const Pose2> poses_world, const DepthMappingSettings& settings,
                    Progress& progress) {
    requireUsable(settings);
    if (poses_world.empty()) throw Error("map", "the robot has not driven yet", "drive a route first");
    progress.report(kStage, 0.0);
    MappingRun run;
    run.T_map_from_world = world.T_map_from_world;
    mapTrajectory(run, world, Raycaster(world), poses_world, settings, progress);
    return run;
}

}  // namespace fodscope
