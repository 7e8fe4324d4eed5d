// SPDX-License-Identifier: MIT
#include "core/simulation/Trials.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/cloud/MeshIo.h"
#include "core/cloud/PointCloudIo.h"
#include "core/common/Error.h"
#include "core/common/Files.h"
#include "core/planning/OccupancyGrid.h"
#include "core/simulation/MeshShapes.h"

namespace fodscope {
namespace {

using nlohmann::json;

/// A FOD with fewer points in the map counts as not observed.
constexpr std::size_t kLeastObserved = 5;

json triple(const Eigen::Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

json rows(const Transform& transform) {
    json result = json::array();
    for (int row = 0; row < 4; ++row) {
        const Eigen::RowVector4d r = transform.matrix().row(row);
        result.push_back({r[0], r[1], r[2], r[3]});
    }
    return result;
}

json poseRows(const std::vector<Transform>& poses) {
    const auto shortened = [](double value) { return std::round(value * 1e4) / 1e4; };
    json result = json::array();
    for (const Transform& pose : poses) {
        const Eigen::Vector3d& t = pose.translation();
        const Eigen::Quaterniond q(pose.linear());
        result.push_back({shortened(t.x()), shortened(t.y()), shortened(t.z()), shortened(q.x()), shortened(q.y()),
                          shortened(q.z()), shortened(q.w())});
    }
    return result;
}

double deviation(const std::vector<double>& values) {
    if (values.size() < 2) return 0.0;
    double mean = 0.0, sum = 0.0;
    for (const double value : values)
        mean += value / static_cast<double>(values.size());
    for (const double value : values)
        sum += (value - mean) * (value - mean);
    return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

/// How far the SLAM's trajectory wandered about the true one.
json driftOf(const MappingRun& run) {
    std::vector<double> x, y, z, yaw, tilt;
    const Transform T_world_from_map = run.T_map_from_world.inverse();
    for (std::size_t i = 0; i < run.trajectory_world.size(); ++i) {
        const Transform believed = T_world_from_map * run.trajectory_map[i];
        const Eigen::Vector3d off = believed.translation() - run.trajectory_world[i].translation();
        const Eigen::Matrix3d turn = believed.linear() * run.trajectory_world[i].linear().transpose();
        x.push_back(off.x());
        y.push_back(off.y());
        z.push_back(off.z());
        yaw.push_back(std::atan2(turn(1, 0), turn(0, 0)));
        tilt.push_back(std::asin(std::clamp(-turn(2, 0), -1.0, 1.0)));
    }
    return {{"std_xy_m", std::sqrt(0.5 * (std::pow(deviation(x), 2) + std::pow(deviation(y), 2)))},
            {"std_yaw_deg", degreesFromRadians(deviation(yaw))},
            {"std_z_m", deviation(z)},
            {"std_roll_pitch_deg", degreesFromRadians(deviation(tilt))},
            {"jumps", json::array()}};
}

json fodOf(const WorldObject& object, std::size_t points, const Eigen::Vector3d& observed_map,
           const Transform& T_map_from_world) {
    const bool observed = points >= kLeastObserved;
    const Eigen::Vector3d centroid_map = T_map_from_world * object.centroid_world;
    json fod = {{"type", object.type},
                {"size_m", triple(boundsOf(object.mesh).sizes())},
                {"centroid_cad", triple(object.centroid_world)},
                {"centroid_map", triple(centroid_map)},
                {"gt_centroid_map", triple(observed ? observed_map : centroid_map)},
                {"map_points_hit", points},
                {"observed", observed}};
    fod["observed_centroid_map"] = points > 0 ? triple(observed_map) : json(nullptr);
    return fod;
}

std::string numbered(const char* prefix, int number) {
    return std::string(prefix) + (number < 10 ? "0" : "") + std::to_string(number);
}

/// The world without the FOD that somebody put into it.
World withoutFod(World world) {
    std::erase_if(world.objects, [](const WorldObject& object) { return object.fod; });
    return world;
}

}  // namespace

std::string trialJson(const std::string& name, const World& world, const MappingRun& run) {
    json root;
    root["name"] = name;
    root["units"] = "m, quaternions x y z w; camera body frame x forward, y left, z up";
    root["points"] = run.map.size();
    root["voxels_before_subset"] = run.voxels;
    root["raw_depth_points"] = run.rawPoints;
    root["frames"] = run.trajectory_map.size();
    root["T_cad_from_map"] = rows(run.T_map_from_world.inverse());
    root["T_map_from_cad"] = rows(run.T_map_from_world);
    root["robot_start_pose_map"] = {{"x", run.robotStart_map.x_m},
                                    {"y", run.robotStart_map.y_m},
                                    {"yaw_deg", degreesFromRadians(run.robotStart_map.yaw_rad)}};
    root["drift"] = driftOf(run);
    root["fods"] = json::array();
    for (std::size_t i = 0; i < world.objects.size(); ++i)
        if (world.objects[i].fod)
            root["fods"].push_back(fodOf(world.objects[i], run.pointsOnObject.at(i), run.observedCentroid_map.at(i),
                                         run.T_map_from_world));
    root["trajectory_estimated_map"] = poseRows(run.trajectory_map);
    root["trajectory_true_cad"] = poseRows(run.trajectory_world);
    return root.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

void writeTrial(const std::filesystem::path& folder, const std::string& name, const World& world,
                const MappingRun& run) {
    makeFolder(folder / "worlds");
    writePointCloud(folder / (name + ".pcd"), run.map, PcdEncoding::BinaryCompressed);
    writeMapServerGrid(folder / (name + ".yaml"), run.grid_map);
    World moved = world;
    moved.name = name;
    moved.T_map_from_world = run.T_map_from_world;
    writeWorld(folder / "worlds" / (name + ".json"), moved);
    // Last: a trial with its JSON is complete.
    writeFile(folder / (name + ".json"), trialJson(name, world, run));
}

std::vector<std::string> simulateTrials(const std::filesystem::path& folder, const TrialSeriesSettings& settings,
                                        Progress& progress) {
    if (settings.count < 1 || settings.count > 1000)
        throw Error("simulate", "a count of " + std::to_string(settings.count) + " is out of range",
                    "ask for 1 to 1000 maps");
    const World base = withoutFod(settings.worldFile ? readWorld(*settings.worldFile) : builtinWorld(settings.tank));
    makeFolder(folder);
    writeMesh(folder / "tank.ply", settings.worldFile ? base.structure : builtinTankCad(settings.tank));
    std::vector<std::string> names;
    for (int i = 0; i < settings.count; ++i) {
        const bool trial = settings.kind == TrialKind::Trial;
        const std::string name = numbered(trial ? "trial_" : "nominal_", i);
        World world = base;
        DepthMappingSettings mapping = settings.mapping;
        mapping.seed = settings.seed + static_cast<std::uint64_t>(i);
        if (trial) placeFod(world, mapping.seed);
        Progress one([&](const std::string& stage, double fraction) {
            progress.report(stage + " (" + name + ")", (i + fraction) / settings.count);
        });
        writeTrial(folder, name, world, mapWorld(world, mapping, one));
        names.push_back(name);
    }
    return names;
}

}  // namespace fodscope
