// SPDX-License-Identifier: MIT
#include "app/robot_simulator/SiteMap.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/simulation/DepthCamera.h"
#include "core/simulation/PhotoCamera.h"
#include "core/simulation/PoseDrift.h"
#include "core/simulation/Random.h"
#include "core/simulation/RustyPaint.h"

namespace fodscope::robot_simulator {
namespace {

constexpr double kTurnOfNewView_rad = 0.25;
/// What the robot stands on is known floor.
constexpr double kOwnFloor_m = 0.3;

Rgb paintedColour(const DepthReturn& seen, const Eigen::Vector3d& point_world) {
    if (seen.object >= 0) return seen.colour;
    const Finish finish = rustyPaint(point_world.cast<float>(), Eigen::Vector3f::UnitZ(), seen.colour);
    const auto channel = [&](int i) {
        return static_cast<std::uint8_t>(std::lround(255.0F * srgbFromLinear(finish.reflectance[i])));
    };
    return {channel(0), channel(1), channel(2)};
}

ColouredPoint colouredPoint(const Eigen::Vector3d& point, Rgb colour) {
    return {static_cast<float>(point.x()),
            static_cast<float>(point.y()),
            static_cast<float>(point.z()),
            colour.red,
            colour.green,
            colour.blue};
}

PercentGrid percentGrid(const OccupancyGrid& grid, std::vector<std::int8_t> percent) {
    return {grid.width, grid.height, grid.resolution_m, grid.origin_map.x_m, grid.origin_map.y_m, std::move(percent)};
}

}  // namespace

SiteMap::SiteMap(std::shared_ptr<const World> world, std::shared_ptr<const Raycaster> raycaster,
                 OccupancyGrid floor_map, const DepthMappingSettings& settings)
    : world_(std::move(world)),
      raycaster_(std::move(raycaster)),
      settings_(settings),
      floor_map_(std::move(floor_map)),
      isKnown_(floor_map_.cells.size(), false),
      voxels_(settings.mapVoxel_m) {}

void SiteMap::begin(FinishedMap map) {
    finished_ = std::move(map.cloud_map);
    path_map_ = std::move(map.path_map);
    isKnown_.assign(isKnown_.size(), true);
    ++version_;
}

bool SiteMap::isNewView(const Pose2& robot_map) const {
    if (!lastView_map_) return true;
    return std::hypot(robot_map.x_m - lastView_map_->x_m, robot_map.y_m - lastView_map_->y_m) >=
               settings_.keyFrameSpacing_m ||
           std::abs(wrapAngle(robot_map.yaw_rad - lastView_map_->yaw_rad)) >= kTurnOfNewView_rad;
}

void SiteMap::see(const Pose2& robot_map, bool learn) {
    if (!isNewView(robot_map)) return;
    lastView_map_ = robot_map;
    ++updates_;
    if (learn) learnFrom(robot_map);
}

void SiteMap::learnFrom(const Pose2& robot_map) {
    PhotoCameraSettings mount;
    mount.height_m = settings_.cameraHeight_m;
    mount.pitchDown_rad = settings_.pitchDown_rad;
    seenFrom_map_.push_back(transformFromPose(robot_map));
    // The drift is a walk along the way, drawn from the seed: its beginning stays as it was.
    const Transform T_map_from_robot = withDrift(seenFrom_map_, settings_).back();
    const Transform T_robot_from_camera = cameraPose(Pose2{}, mount);
    const Transform T_world_from_map = world_->T_map_from_world.inverse();
    const Transform T_world_from_camera = T_world_from_map * seenFrom_map_.back() * T_robot_from_camera;
    const Transform T_map_from_camera = T_map_from_robot * T_robot_from_camera;
    const Eigen::Vector2d eye_map = T_map_from_camera.translation().head<2>();

    uncoverAround(robot_map);
    for (const DepthReturn& seen : depthFrame(*raycaster_, T_world_from_camera, settings_,
                                              streamSeed(settings_.seed, 1000 + seenFrom_map_.size()))) {
        const Eigen::Vector3d point_camera = seen.point_camera.cast<double>();
        const Eigen::Vector3d point_map = T_map_from_camera * point_camera;
        voxels_.add(point_map, paintedColour(seen, T_world_from_camera * point_camera), seen.object);
        uncoverLine(eye_map, point_map.head<2>());
    }
    path_map_.push_back(poseFromTransform(T_map_from_robot));
    ++version_;
}

void SiteMap::uncoverLine(const Eigen::Vector2d& from_map, const Eigen::Vector2d& to_map) {
    const Eigen::Vector2d way = to_map - from_map;
    const int steps = static_cast<int>(std::ceil(way.norm() / (0.5 * floor_map_.resolution_m)));
    for (int i = 0; i <= steps; ++i) {
        const CellIndex cell = floor_map_.cellAt(from_map + way * i / std::max(steps, 1));
        if (floor_map_.contains(cell)) isKnown_[floor_map_.offset(cell)] = true;
    }
}

void SiteMap::uncoverAround(const Pose2& robot_map) {
    const Eigen::Vector2d robot(robot_map.x_m, robot_map.y_m);
    for (int row = 0; row < floor_map_.height; ++row)
        for (int column = 0; column < floor_map_.width; ++column)
            if ((floor_map_.centreOf({column, row}) - robot).norm() <= kOwnFloor_m)
                isKnown_[floor_map_.offset({column, row})] = true;
}

std::vector<ColouredPoint> SiteMap::cloud() const {
    std::vector<ColouredPoint> points;
    const std::vector<MapVoxels::Voxel> voxels = voxels_.sorted();
    points.reserve(finished_.points.size() + voxels.size());
    const bool coloured = finished_.colours.size() == finished_.points.size();
    for (std::size_t i = 0; i < finished_.points.size(); ++i)
        points.push_back(colouredPoint(finished_.points[i], coloured ? finished_.colours[i] : Rgb{128, 128, 128}));
    for (const MapVoxels::Voxel& voxel : voxels) {
        const Eigen::Vector3d mean = voxel.mean();
        if (mean.z() < settings_.mapMinimumHeight_m || mean.z() > settings_.mapMaximumHeight_m) continue;
        points.push_back(colouredPoint(mean, voxel.colour()));
    }
    return points;
}

/// As a SLAM's grid it reaches as far as something was seen, and grows.
OccupancyGrid SiteMap::knownPart() const {
    CellIndex low{floor_map_.width, floor_map_.height}, high{-1, -1};
    for (int row = 0; row < floor_map_.height; ++row)
        for (int column = 0; column < floor_map_.width; ++column) {
            if (!isKnown_[floor_map_.offset({column, row})]) continue;
            low = {std::min(low.column, column), std::min(low.row, row)};
            high = {std::max(high.column, column), std::max(high.row, row)};
        }
    OccupancyGrid known;
    known.resolution_m = floor_map_.resolution_m;
    known.origin_map = floor_map_.origin_map;
    if (high.column < 0) return known;
    known.width = high.column - low.column + 1;
    known.height = high.row - low.row + 1;
    known.origin_map.x_m += low.column * known.resolution_m;
    known.origin_map.y_m += low.row * known.resolution_m;
    for (int row = low.row; row <= high.row; ++row)
        for (int column = low.column; column <= high.column; ++column) {
            const std::size_t cell = floor_map_.offset({column, row});
            known.cells.push_back(isKnown_[cell] ? floor_map_.cells[cell] : Cell::Unknown);
        }
    return known;
}

PercentGrid SiteMap::grid() const {
    const OccupancyGrid known = knownPart();
    std::vector<std::int8_t> percent;
    percent.reserve(known.cells.size());
    for (const Cell cell : known.cells)
        percent.push_back(cell == Cell::Unknown ? -1 : cell == Cell::Occupied ? 100 : 0);
    return percentGrid(known, std::move(percent));
}

PercentGrid SiteMap::costMap() const {
    const OccupancyGrid known = knownPart();
    if (known.cells.empty()) return percentGrid(known, {});
    std::vector<std::int8_t> percent;
    percent.reserve(known.cells.size());
    for (const std::uint8_t cost : inflate(known, CostMapSettings{}).costs)
        percent.push_back(cost == kCostUnknown ? std::int8_t{-1} : static_cast<std::int8_t>(costPercent(cost)));
    return percentGrid(known, std::move(percent));
}

}  // namespace fodscope::robot_simulator
