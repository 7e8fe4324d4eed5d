// SPDX-License-Identifier: MIT
#include "core/simulation/SimulatedRobot.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <future>
#include <mutex>
#include <utility>

#include "core/common/Error.h"
#include "core/common/Progress.h"
#include "core/simulation/DriveMotion.h"
#include "core/simulation/Raycaster.h"

namespace fodscope {
namespace {

void requireInRange(const SimulatedRobotSettings& settings) {
    const auto isSpeed = [](double value) { return value > 0.0 && std::isfinite(value); };
    const auto isDelay = [](double value) { return value >= 0.0 && std::isfinite(value); };
    if (!isSpeed(settings.speed_m_per_s) || !isSpeed(settings.turnSpeed_rad_per_s) ||
        !isDelay(settings.acknowledgeDelay_s) || !isDelay(settings.photoDelay_s)) {
        throw Error("simulated robot", "a setting is out of range", "give speeds over 0 and delays of 0 s or more");
    }
}

/// The world as the camera sees it. Building the ray caster takes a moment, so the first photo does it, off the
/// caller's thread.
class Studio {
  public:
    explicit Studio(std::shared_ptr<const World> world) : world_(std::move(world)) {}

    std::vector<std::byte> photograph(const Transform& T_map_from_camera, const PhotoCameraSettings& camera,
                                      const Progress& progress) {
        progress.throwIfCancelled();
        std::call_once(built_, [this] { raycaster_ = std::make_unique<Raycaster>(*world_); });
        return renderPhoto(*world_, *raycaster_, world_->T_map_from_world.inverse() * T_map_from_camera, camera,
                           progress);
    }

  private:
    std::shared_ptr<const World> world_;
    std::once_flag built_;
    std::unique_ptr<Raycaster> raycaster_;
};

/// A photo that is being made. Who no longer wants it destroys it and does not wait for its last row.
class Rendering {
  public:
    Rendering() = default;
    Rendering(std::shared_ptr<Studio> studio, const Transform& T_map_from_camera, const PhotoCameraSettings& camera)
        : progress_(std::make_shared<Progress>()),
          bytes_(std::async(std::launch::async,
                            [studio = std::move(studio), T_map_from_camera, camera, progress = progress_] {
                                return studio->photograph(T_map_from_camera, camera, *progress);
                            })) {}
    ~Rendering() {
        if (progress_) progress_->cancel();
    }
    Rendering(Rendering&&) = default;
    Rendering& operator=(Rendering&&) = default;

    bool hasBegun() const { return bytes_.valid(); }
    bool isDoneWithin(std::chrono::milliseconds time) const {
        return bytes_.wait_for(time) == std::future_status::ready;
    }
    std::vector<std::byte> take() { return bytes_.get(); }

  private:
    std::shared_ptr<Progress> progress_;
    std::future<std::vector<std::byte>> bytes_;
};

/// A map that is being made. Who no longer wants it destroys it.
class MapMaking {
  public:
    MapMaking() = default;
    MapMaking(std::shared_ptr<const World> world, std::vector<Pose2> poses_world, const DepthMappingSettings& settings)
        : progress_(std::make_shared<Progress>()),
          map_(std::async(std::launch::async, [world = std::move(world), poses_world = std::move(poses_world), settings,
                                               progress = progress_] {
              return std::make_shared<const PointCloud>(mapAlong(*world, poses_world, settings, *progress).map);
          })) {}
    ~MapMaking() {
        if (progress_) progress_->cancel();
    }
    MapMaking(MapMaking&&) = default;
    MapMaking& operator=(MapMaking&&) = default;

    bool isDoneWithin(std::chrono::milliseconds time) const { return map_.wait_for(time) == std::future_status::ready; }
    std::shared_ptr<const PointCloud> take() { return map_.get(); }

  private:
    std::shared_ptr<Progress> progress_;
    std::future<std::shared_ptr<const PointCloud>> map_;
};

/// Of one poll to the next, with a step of its own between key frames.
bool isNextKeyFrame(const Pose2& last, const Pose2& now, const DepthMappingSettings& settings) {
    constexpr double kTurn_rad = 0.7;
    return std::hypot(now.x_m - last.x_m, now.y_m - last.y_m) >= settings.keyFrameSpacing_m ||
           std::abs(wrapAngle(now.yaw_rad - last.yaw_rad)) >= kTurn_rad;
}

class SimulatedRobot : public RobotLink {
  public:
    SimulatedRobot(std::shared_ptr<const World> world, OccupancyGrid grid_map, std::shared_ptr<const PointCloud> map,
                   const CostMapSettings& costMap, const SimulatedRobotSettings& settings)
        : world_(std::move(world)),
          map_(std::move(map)),
          costMap_(inflate(grid_map, costMap)),
          settings_(settings),
          studio_(std::make_shared<Studio>(world_)),
          pose_map_(poseFromTransform(world_->T_map_from_world * transformFromPose(world_->robotStart_world))) {
        requireInRange(settings_);
        floodFill(costMap_, pose_map_);
    }

    std::string name() const override { return "simulated robot"; }
    void connect() override { connected_ = true; }
    void disconnect() override;
    void requestMap() override;
    void requestGrid() override;
    void sendGoal(const RobotGoal& goal) override;
    void cancelAllGoals() override;
    void requestPhoto(const std::string& requestId) override;
    std::vector<RobotEvent> poll(double now_s) override;

  private:
    struct Drive {
        RobotGoal goal;
        /// Empty until the first poll after it, when nothing was polled before.
        std::optional<double> sent_s;
        double accepted_s = 0.0;
        std::optional<DriveMotion> motion;
    };
    struct Exposure {
        std::string requestId;
        std::optional<double> requested_s;
        double due_s = 0.0;
        Photo photo;
        Rendering rendering;
    };

    bool isMoving() const { return drive_ && drive_->motion; }
    void endDrive(GoalFailure failure, const std::string& message);
    void moveOn(double now_s);
    void accept();
    void expose(Exposure& exposure, double now_s);
    void develop(double now_s);
    bool isDeveloped(const Exposure& exposure, double now_s) const;
    template <typename Work>
    bool isReady(const Work& work) const;
    void noteKeyFrame();
    void deliverMap();
    RobotState state() const;

    std::shared_ptr<const World> world_;
    std::shared_ptr<const PointCloud> map_;
    CostMap costMap_;
    SimulatedRobotSettings settings_;
    std::shared_ptr<Studio> studio_;
    bool connected_ = false;
    std::optional<double> now_s_;
    Pose2 pose_map_;
    double stillSince_s_ = 0.0;
    std::optional<Drive> drive_;
    std::vector<Exposure> exposures_;
    /// Where it was while it mapped, map frame.
    std::vector<Pose2> keyFrames_map_;
    std::optional<MapMaking> mapMaking_;
    std::vector<RobotEvent> events_;
};

void SimulatedRobot::disconnect() {
    if (!connected_) return;
    drive_.reset();
    exposures_.clear();
    mapMaking_.reset();
    connected_ = false;
    events_.emplace_back(RobotStateChanged{state()});
}

void SimulatedRobot::requestMap() {
    if (settings_.mapping && connected_) {
        const Transform T_world_from_map = world_->T_map_from_world.inverse();
        std::vector<Pose2> poses_world;
        for (const Pose2& pose : keyFrames_map_)
            poses_world.push_back(poseFromTransform(T_world_from_map * transformFromPose(pose)));
        mapMaking_.emplace(world_, std::move(poses_world), *settings_.mapping);
    } else if (map_) {
        events_.emplace_back(MapReceived{map_});
    } else {
        events_.emplace_back(LinkMessage{"the simulated robot has no map"});
    }
}

void SimulatedRobot::requestGrid() {
    events_.emplace_back(GridReceived{costMap_.grid});
}

void SimulatedRobot::sendGoal(const RobotGoal& goal) {
    if (!connected_) {
        events_.emplace_back(GoalFailed{goal.id, GoalFailure::LinkLost, "the robot is not connected"});
        return;
    }
    const Pose2& pose = goal.pose_map;
    if (!std::isfinite(pose.x_m) || !std::isfinite(pose.y_m) || !std::isfinite(pose.yaw_rad)) {
        events_.emplace_back(GoalFailed{goal.id, GoalFailure::Rejected, "the goal's pose is no number"});
        return;
    }
    endDrive(GoalFailure::Preempted, "a newer goal came");
    drive_ = Drive{goal, now_s_, 0.0, std::nullopt};
}

void SimulatedRobot::cancelAllGoals() {
    endDrive(GoalFailure::StopRequested, "");
}

void SimulatedRobot::requestPhoto(const std::string& requestId) {
    if (!connected_) {
        events_.emplace_back(PhotoFailed{requestId, PhotoFailure::LinkLost, "the robot is not connected"});
        return;
    }
    Exposure exposure;
    exposure.requestId = requestId;
    exposure.requested_s = now_s_;
    if (now_s_ && !isMoving()) expose(exposure, *now_s_);
    exposures_.push_back(std::move(exposure));
}

std::vector<RobotEvent> SimulatedRobot::poll(double now_s) {
    if (now_s_ && !(now_s >= *now_s_)) now_s = *now_s_;
    if (connected_) moveOn(now_s);
    now_s_ = now_s;
    if (connected_) {
        noteKeyFrame();
        develop(now_s);
        deliverMap();
        events_.emplace_back(RobotStateChanged{state()});
    }
    return std::exchange(events_, {});
}

/// The robot stops where it was at the last poll.
void SimulatedRobot::endDrive(GoalFailure failure, const std::string& message) {
    if (!drive_) return;
    events_.emplace_back(GoalFailed{drive_->goal.id, failure, message});
    drive_.reset();
    stillSince_s_ = now_s_.value_or(stillSince_s_);
}

void SimulatedRobot::moveOn(double now_s) {
    if (!drive_) return;
    if (!drive_->sent_s) drive_->sent_s = now_s;
    if (!drive_->motion) {
        if (now_s < *drive_->sent_s + settings_.acknowledgeDelay_s) return;
        accept();
        if (!drive_) return;
    }
    const double driven_s = now_s - drive_->accepted_s;
    pose_map_ = drive_->motion->poseAt(driven_s);
    if (driven_s < drive_->motion->duration_s()) return;
    stillSince_s_ = drive_->accepted_s + drive_->motion->duration_s();
    events_.emplace_back(GoalArrived{drive_->goal.id, pose_map_});
    drive_.reset();
}

void SimulatedRobot::accept() {
    drive_->accepted_s = *drive_->sent_s + settings_.acknowledgeDelay_s;
    events_.emplace_back(GoalAccepted{drive_->goal.id});
    const Pose2& goal_map = drive_->goal.pose_map;
    const TravelField field(costMap_, {pose_map_.x_m, pose_map_.y_m});
    const auto path = field.pathTo({goal_map.x_m, goal_map.y_m});
    if (path) {
        drive_->motion.emplace(pose_map_, *path, goal_map, settings_.speed_m_per_s, settings_.turnSpeed_rad_per_s);
    } else {
        endDrive(GoalFailure::Aborted, "no path leads to the goal");
    }
}

/// Takes the photo where the robot stands; it is rendered meanwhile, and handed over when it is due.
void SimulatedRobot::expose(Exposure& exposure, double now_s) {
    if (!exposure.requested_s) exposure.requested_s = now_s;
    exposure.due_s = std::max(*exposure.requested_s, stillSince_s_) + settings_.photoDelay_s;
    PhotoCameraSettings camera = settings_.camera;
    // No two photos alike, not even after the robot or the program was started anew.
    camera.seed += std::hash<std::string>()(exposure.requestId) & 0xffffffffU;
    Photo& photo = exposure.photo;
    photo.taken = UtcTime::now();
    photo.T_map_from_camera = cameraPose(pose_map_, camera);
    photo.intrinsics = intrinsicsOf(camera);
    photo.mediaType = "image/jpeg";
    exposure.rendering = Rendering(studio_, photo.T_map_from_camera, camera);
}

void SimulatedRobot::develop(double now_s) {
    for (Exposure& exposure : exposures_) {
        if (!exposure.rendering.hasBegun() && !isMoving()) expose(exposure, now_s);
    }
    const auto done = std::stable_partition(exposures_.begin(), exposures_.end(),
                                            [&](const Exposure& exposure) { return !isDeveloped(exposure, now_s); });
    for (auto exposure = done; exposure != exposures_.end(); ++exposure) {
        try {
            exposure->photo.bytes = exposure->rendering.take();
            events_.emplace_back(PhotoReceived{exposure->requestId, std::move(exposure->photo)});
        } catch (const std::exception& problem) {
            events_.emplace_back(PhotoFailed{exposure->requestId, PhotoFailure::Missing, problem.what()});
        }
    }
    exposures_.erase(done, exposures_.end());
}

bool SimulatedRobot::isDeveloped(const Exposure& exposure, double now_s) const {
    return exposure.rendering.hasBegun() && now_s >= exposure.due_s && isReady(exposure.rendering);
}

template <typename Work>
bool SimulatedRobot::isReady(const Work& work) const {
    constexpr std::chrono::milliseconds kShortWait(20);
    if (!settings_.waitForRendering) return work.isDoneWithin(std::chrono::milliseconds(0));
    do {
        if (settings_.isWaitOver && settings_.isWaitOver()) return false;
    } while (!work.isDoneWithin(kShortWait));
    return true;
}

void SimulatedRobot::noteKeyFrame() {
    if (!settings_.mapping) return;
    if (keyFrames_map_.empty() || isNextKeyFrame(keyFrames_map_.back(), pose_map_, *settings_.mapping))
        keyFrames_map_.push_back(pose_map_);
}

void SimulatedRobot::deliverMap() {
    if (!mapMaking_ || !isReady(*mapMaking_)) return;
    try {
        events_.emplace_back(MapReceived{mapMaking_->take()});
    } catch (const std::exception& problem) {
        events_.emplace_back(LinkMessage{std::string("no map: ") + problem.what()});
    }
    mapMaking_.reset();
}

RobotState SimulatedRobot::state() const {
    RobotState state;
    state.link = connected_ ? LinkState::Connected : LinkState::Disconnected;
    state.pose_map = pose_map_;
    state.poseMeasured_s = now_s_.value_or(0.0);
    state.moving = isMoving();
    if (!isMoving()) return state;
    state.goalId = drive_->goal.id;
    state.distanceLeft_m = drive_->motion->distanceLeftAt(state.poseMeasured_s - drive_->accepted_s);
    return state;
}

}  // namespace

std::unique_ptr<RobotLink> makeSimulatedRobot(std::shared_ptr<const World> world, OccupancyGrid grid_map,
                                              std::shared_ptr<const PointCloud> map, const CostMapSettings& costMap,
                                              const SimulatedRobotSettings& settings) {
    if (!world) throw Error("simulated robot", "it has no world to drive in", "give a world");
    return std::make_unique<SimulatedRobot>(std::move(world), std::move(grid_map), std::move(map), costMap, settings);
}

}  // namespace fodscope
