// SPDX-License-Identifier: MIT
#include <utility>

#include "app/robot_simulator/CameraFeed.h"
#include "app/robot_simulator/RobotBody.h"
#include "app/robot_simulator/RobotModel.h"
#include "app/robot_simulator/SiteMap.h"
#include "core/cloud/PointCloudIo.h"
#include "core/common/Error.h"
#include "core/simulation/BuiltinDemo.h"
#include "core/simulation/FloorGrid.h"

namespace fodscope::robot_simulator {
namespace {

PlanarPose planar(const Pose2& pose) {
    return {pose.x_m, pose.y_m, pose.yaw_rad};
}

Pose2 pose2(const PlanarPose& pose) {
    return {pose.x_m, pose.y_m, pose.yaw_rad};
}

DepthMappingSettings mappingSettings(const ModelSettings& settings) {
    DepthMappingSettings mapping = quickMapping();
    mapping.seed = settings.seed;
    return mapping;
}

/// A world file says where its map frame lies; in the built-in tank it lies where the SLAM of this seed begins.
World worldOf(const ModelSettings& settings) {
    if (settings.world != "builtin") return readWorld(settings.world);
    World world = builtinWorld({});
    placeFod(world, settings.fodSeed);
    world.T_map_from_world = drawMapFrame(mappingSettings(settings));
    return world;
}

FinishedMap simulatedMap(const World& world, const DepthMappingSettings& settings) {
    Progress progress;
    MappingRun run = mapWorld(world, settings, progress);
    const Transform T_map_from_run = world.T_map_from_world * run.T_map_from_world.inverse();
    FinishedMap map;
    map.cloud_map = std::move(run.map);
    for (Eigen::Vector3d& point : map.cloud_map.points)
        point = T_map_from_run * point;
    for (const Transform& pose_run : run.trajectory_map)
        map.path_map.push_back(poseFromTransform(T_map_from_run * pose_run));
    return map;
}

PhotoCameraSettings cameraOf(const ModelSettings& settings) {
    PhotoCameraSettings camera;
    camera.width_px = settings.imageWidth_px;
    camera.height_px = settings.imageHeight_px;
    camera.seed = settings.seed;
    return camera;
}

class SimulatedModel : public RobotModel {
  public:
    SimulatedModel(std::shared_ptr<const World> world, const ModelSettings& settings)
        : SimulatedModel(world, std::make_shared<const Raycaster>(*world), startOf(*world, settings), settings) {}

    void advance(double now_s) override {
        body_.advance(now_s);
        map_.see(body_.pose_map(), isMapping_);
        feed_.advance(now_s, body_.pose_map(), body_.stillSince_s().has_value());
    }

    PlanarPose pose_map() const override { return planar(body_.pose_map()); }
    PlanarPose start_map() const override { return planar(start_map_); }
    Velocity velocity() const override { return body_.velocity(); }

    bool driveTo(const PlanarPose& goal_map) override { return body_.driveTo(pose2(goal_map)); }
    bool isDriving() const override { return body_.isDriving(); }
    double drivenShare() const override { return body_.drivenShare(); }
    void stop() override { body_.stop(); }
    void command(const Velocity& velocity) override { body_.command(velocity); }

    bool isMapping() const override { return isMapping_; }
    void setMapping(bool on) override { isMapping_ = on; }
    std::uint64_t mapUpdates() const override { return map_.updates(); }
    std::uint64_t mapVersion() const override { return map_.version(); }
    std::vector<ColouredPoint> mapCloud() const override { return map_.cloud(); }
    PercentGrid grid() const override { return map_.grid(); }
    PercentGrid costMap() const override { return map_.costMap(); }
    std::vector<PlanarPose> mapPath() const override {
        std::vector<PlanarPose> path;
        for (const Pose2& pose : map_.path_map())
            path.push_back(planar(pose));
        return path;
    }

    CameraShape camera() const override {
        const CameraIntrinsics intrinsics = intrinsicsOf(camera_);
        return {intrinsics.width_px, intrinsics.height_px, intrinsics.fx_px, intrinsics.fy_px,
                intrinsics.cx_px,    intrinsics.cy_px,     camera_.height_m, camera_.pitchDown_rad};
    }
    void setCameraWanted(bool wanted) override { feed_.setWanted(wanted); }
    std::optional<Picture> takePicture() override { return feed_.take(); }

  private:
    SimulatedModel(const std::shared_ptr<const World>& world, const std::shared_ptr<const Raycaster>& raycaster,
                   const Pose2& start_map, const ModelSettings& settings)
        : SimulatedModel(world, raycaster, start_map, floorOf(*world, *raycaster), settings) {}

    SimulatedModel(const std::shared_ptr<const World>& world, const std::shared_ptr<const Raycaster>& raycaster,
                   const Pose2& start_map, const OccupancyGrid& floor_map, const ModelSettings& settings)
        : start_map_(start_map),
          camera_(cameraOf(settings)),
          body_(inflate(floor_map, CostMapSettings{}), start_map, settings),
          map_(world, raycaster, floor_map, mappingSettings(settings)),
          feed_(world, raycaster, camera_, settings.imageRate_hz),
          isMapping_(!settings.mapped) {
        if (!settings.mapped) return;
        map_.begin(settings.mapFile.empty() ? simulatedMap(*world, mappingSettings(settings))
                                            : FinishedMap{readPointCloud(settings.mapFile), {}});
    }

    static Pose2 worldStart(const World& world) {
        return poseFromTransform(world.T_map_from_world * transformFromPose(world.robotStart_world));
    }
    static Pose2 startOf(const World& world, const ModelSettings& settings) {
        return settings.start_map ? pose2(*settings.start_map) : worldStart(world);
    }
    /// The floor that the robot can get to. That is judged from the world's start, wherever it stands now.
    static OccupancyGrid floorOf(const World& world, const Raycaster& raycaster) {
        return explored(floorGrid(world, raycaster, world.T_map_from_world, {}), worldStart(world));
    }

    Pose2 start_map_;
    PhotoCameraSettings camera_;
    RobotBody body_;
    SiteMap map_;
    CameraFeed feed_;
    bool isMapping_;
};

}  // namespace

std::unique_ptr<RobotModel> makeRobotModel(const ModelSettings& settings) {
    return std::make_unique<SimulatedModel>(std::make_shared<const World>(worldOf(settings)), settings);
}

}  // namespace fodscope::robot_simulator
