// SPDX-License-Identifier: MIT
#include "app/ros1_bridge/RobotBridge.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/ros1_bridge/CloudConversion.h"
#include "core/common/Error.h"

namespace fodscope::bridge {
namespace {

constexpr double kStateEvery_s = 0.1;
constexpr double kStreamsEvery_s = 0.5;
/// A connection to an action server that is there is made within this time.
constexpr double kServerFoundWithin_s = 2.0;
constexpr double kPoseUsableFor_s = 3.0;

PhotoSettings photoSettings(const ParameterValues& parameters) {
    return {parameters.text("map_frame"),   parameters.text("odom_frame"),      parameters.text("image"),
            parameters.text("camera_info"), parameters.number("photo_timeout"), parameters.number("tf_timeout")};
}

}  // namespace

RobotBridge::RobotBridge(RosPort& port, const ParameterValues& parameters, const Configure& configuration, Tell tell)
    : port_(port),
      parameters_(parameters),
      masterUri_(configuration.masterUri),
      tell_(std::move(tell)),
      streams_(parameters),
      robot_(port, parameters),
      still_({parameters.number("still_speed"), parameters.number("still_time"), 1.0}),
      photos_(photoSettings(parameters), port, still_, tell_),
      goals_(configuration.goalPrefix, [this](Event event) { tellOfGoal(std::move(event)); }),
      hand_(parameters.number("drive_speed"), parameters.number("turn_speed")) {}

void RobotBridge::handle(const Request& request, double now_s) {
    now_s_ = now_s;
    std::visit([this](const auto& each) { carryOut(each); }, request);
}

void RobotBridge::onMaster(const MasterSighting& sighting, double now_s) {
    now_s_ = now_s;
    const bool answered = std::exchange(masterAnswers_, sighting.answers);
    if (!sighting.answers) {
        if (answered) note("the ROS master at " + masterUri_ + " no longer answers; what is connected goes on");
        return;
    }
    topics_ = sighting.topics;
    if (masterProcess_ != sighting.processId) {
        if (masterProcess_) note("the ROS master was restarted; everything was registered anew");
        masterProcess_ = sighting.processId;
        port_.attach(*this);
    }
    chooseImageTransport();
}

void RobotBridge::tick(double now_s) {
    now_s_ = now_s;
    if (isAttached()) {
        port_.spin();
        sendPendingGoal();
        goals_.onTick(now_s_);
        repeatCancel();
        photos_.onTick(now_s_);
        driveByHand();
        watchMapRequest();
        if (isGridWanted_) sendGrid();
    }
    if (now_s_ - stateSent_s_ >= kStateEvery_s) {
        stateSent_s_ = now_s_;
        if (isAttached()) note(robot_.look(now_s_));
        tell_(state());
    }
    if (now_s_ - streamsSent_s_ >= kStreamsEvery_s) {
        streamsSent_s_ = now_s_;
        tell_(streams_.at(now_s_));
    }
}

void RobotBridge::workstationLost() {
    if (isAttached() && hand_.isDriving()) port_.publishSpeeds(0.0, 0.0);
}

void RobotBridge::note(const std::string& text) {
    if (!text.empty()) tell_(Note{text});
}

State RobotBridge::state() const {
    State state;
    const auto heard_s = streams_.lifeSign_s();
    const bool isHeard = heard_s && now_s_ - *heard_s <= parameters_.number("lost_after");
    if (!isAttached()) {
        state.reason = "no ROS master answers at " + masterUri_;
    } else if (isHeard || (masterAnswers_ && !heard_s)) {
        state.link = Link::Connected;
    } else {
        state.link = Link::Lost;
        state.reason = masterAnswers_ ? "nothing is heard of the robot any more"
                                      : "neither the ROS master nor the robot is heard any more";
    }
    state.pose_map = robot_.pose_map();
    state.poseAge_s = state.pose_map ? robot_.poseAge_s(now_s_) : 0.0;
    state.moving = still_.isMoving(now_s_);
    state.stillFor_s = still_.stillFor_s(now_s_);
    state.goalId = goals_.goalUnderWay();
    state.anyGoalUnderWay = goals_.anyGoalUnderWay();
    state.clockAhead_s = robot_.clockAhead_s();
    if (state.goalId && goal_map_ && state.pose_map)
        state.distanceLeft_m = std::hypot(goal_map_->x_m - state.pose_map->x_m, goal_map_->y_m - state.pose_map->y_m);
    return state;
}

// --- what the workstation asks ---------------------------------------------------------------------------------------

void RobotBridge::carryOut(const FetchMap&) {
    mapAsked_s_ = now_s_;
    port_.watchCloud(true);
}

void RobotBridge::carryOut(const FollowMap& request) {
    followsMap_ = request.on;
    port_.watchCloud(followsMap_ || mapAsked_s_);
}

void RobotBridge::carryOut(const FetchGrid&) {
    isGridWanted_ = true;
}

void RobotBridge::carryOut(const SendGoal& goal) {
    pendingGoal_ = PendingGoal{goal, now_s_};
    if (isAttached()) sendPendingGoal();
}

void RobotBridge::carryOut(const CancelAllGoals&) {
    if (pendingGoal_) failPendingGoal(GoalProblem::StopRequested, "");
    if (!isAttached()) return;
    goals_.cancelled(now_s_);
    port_.publishCancelAll();
}

void RobotBridge::carryOut(const TakePhoto& request) {
    photos_.request(request.requestId, goals_.lastArrived(), now_s_);
}

void RobotBridge::carryOut(const Drive& request) {
    const bool wasDriving = hand_.isDriving();
    if (!wasDriving && goals_.anyGoalUnderWay()) {
        note("driving by hand waits until no goal is under way; press STOP first");
        return;
    }
    hand_.request(request, now_s_);
}

void RobotBridge::carryOut(const CallService& request) {
    const auto isService = [&](const ParameterInfo& info) {
        return info.kind == ParameterKind::Service && request.service == info.name;
    };
    if (std::none_of(parameterTable().begin(), parameterTable().end(), isService)) {
        tell_(ServiceAnswered{request.service, false, "there is no such service"});
    } else if (!isAttached()) {
        tell_(ServiceAnswered{request.service, false, "no ROS master answers at " + masterUri_});
    } else {
        port_.callService(request.service);
    }
}

void RobotBridge::carryOut(const ListTopics&) {
    tell_(Topics{topics_});
}

// --- goals -----------------------------------------------------------------------------------------------------------

void RobotBridge::tellOfGoal(Event event) {
    if (auto* arrived = std::get_if<GoalArrived>(&event)) arrived->pose_map = robot_.pose_map();
    tell_(std::move(event));
}

void RobotBridge::failPendingGoal(GoalProblem problem, const std::string& message) {
    tell_(GoalFailed{pendingGoal_->goal.id, problem, message});
    pendingGoal_.reset();
}

std::string RobotBridge::goalFrame() const {
    return costMap_.isThere() ? costMap_.frame() : parameters_.text("map_frame");
}

std::optional<PlanarPose> RobotBridge::inGoalFrame(const PlanarPose& pose_map) const {
    const std::string& map = parameters_.text("map_frame");
    if (goalFrame() == map) return pose_map;
    const auto goalFromMap = port_.lookup(goalFrame(), map, std::nullopt);
    if (!goalFromMap) return std::nullopt;
    const double c = std::cos(pose_map.yaw_rad);
    const double s = std::sin(pose_map.yaw_rad);
    return planarPartOf(product(goalFromMap->T_target_from_source,
                                {c, -s, 0, pose_map.x_m, s, c, 0, pose_map.y_m, 0, 0, 1, 0, 0, 0, 0, 1}));
}

/// Waits for the connection to the action server, which takes a moment after a start, and for the robot's pose.
void RobotBridge::sendPendingGoal() {
    if (!pendingGoal_) return;
    const bool isLate = now_s_ - pendingGoal_->since_s >= kServerFoundWithin_s;
    const auto refuse = [&](const std::string& message) {
        if (isLate) failPendingGoal(GoalProblem::LinkLost, message);
    };
    if (port_.goalListeners() == 0)
        return refuse("no navigation listens on " + parameters_.text("move_base") + "/goal");
    const std::string chain = parameters_.text("map_frame") + " to " + parameters_.text("base_frame");
    if (!robot_.pose_map()) return refuse("where the robot stands is not known: no transform from " + chain);
    if (robot_.poseAge_s(now_s_) > kPoseUsableFor_s)
        return refuse("where the robot stands is not known any more: the transform from " + chain + " is old");
    const auto pose = inGoalFrame(pendingGoal_->goal.pose_map);
    if (!pose) return refuse("no transform leads to the frame of the robot's cost map, " + goalFrame());

    // A server cancels a goal stamped earlier than the one it has, and clocks differ.
    const double ahead_s = robot_.clockAhead_s().value_or(0.0);
    const auto stamp_ns =
        std::max(port_.now_ns() + static_cast<std::int64_t>(ahead_s * 1e9), goals_.latestStamp_ns() + 1'000'000);
    const SendGoal goal = std::exchange(pendingGoal_, std::nullopt)->goal;
    goals_.sent(goal.id, now_s_);
    goal_map_ = goal.pose_map;
    port_.publishGoal({goals_.idOnRobot(goal.id), stamp_ns, ActionStatus::Pending, ""}, goalFrame(), *pose);
}

/// Cancels get lost on a bad link.
void RobotBridge::repeatCancel() {
    if (!goals_.isCancelDue(now_s_)) return;
    goals_.cancelled(now_s_);
    port_.publishCancelAll();
}

void RobotBridge::driveByHand() {
    if (const auto speeds = hand_.due(now_s_)) port_.publishSpeeds(speeds->forward_m_per_s, speeds->turn_rad_per_s);
}

void RobotBridge::onGoalStatus(const std::vector<GoalStatusMessage>& goals) {
    streams_.heard("navigation", now_s_);
    goals_.onStatus(goals, now_s_);
}

void RobotBridge::onGoalResult(const GoalStatusMessage& result) {
    goals_.onResult(result);
}

// --- maps and grids --------------------------------------------------------------------------------------------------

std::optional<Rows> RobotBridge::toMap(const std::string& frame, bool& isKnown) const {
    isKnown = true;
    if (frame == parameters_.text("map_frame")) return std::nullopt;
    const auto found = port_.lookup(parameters_.text("map_frame"), frame, std::nullopt);
    isKnown = found.has_value();
    return found ? std::optional<Rows>(found->T_target_from_source) : std::nullopt;
}

void RobotBridge::onCloud(const CloudMessage& message) {
    streams_.heard("map cloud", now_s_);
    bool isKnown = false;
    const auto T_map_from_cloud = toMap(message.frame, isKnown);
    try {
        if (!isKnown)
            throw Error("map cloud",
                        "no transform leads from its frame " + message.frame + " to " + parameters_.text("map_frame"),
                        "wait for the robot's transforms, or set the map frame");
        tell_(mapCloudOf(message, T_map_from_cloud));
        streams_.setNote("map cloud", "");
        mapAsked_s_.reset();
        port_.watchCloud(followsMap_);
    } catch (const Error& error) {
        streams_.setNote("map cloud", error.problem());
        if (mapAsked_s_) note(error.what());
        mapAsked_s_.reset();
    }
}

void RobotBridge::watchMapRequest() {
    if (!mapAsked_s_ || now_s_ - *mapAsked_s_ < parameters_.number("map_timeout")) return;
    mapAsked_s_.reset();
    note("no map came from " + parameters_.text("map_cloud") +
         ": RTAB-Map sends it when its map changes; let the robot move a little, or ask it to publish its map");
    port_.watchCloud(followsMap_);
}

void RobotBridge::onGrid(const GridMessage& message, bool isCostMap) {
    const char* name = isCostMap ? "cost map" : "grid";
    streams_.heard(name, now_s_);
    try {
        (isCostMap ? costMap_ : map_).take(message);
        streams_.setNote(name, "");
    } catch (const Error& error) {
        streams_.setNote(name, error.problem());
    }
}

void RobotBridge::onGridUpdate(const GridUpdateMessage& message, bool isCostMap) {
    const char* name = isCostMap ? "cost map" : "grid";
    streams_.heard(name, now_s_);
    try {
        (isCostMap ? costMap_ : map_).apply(message);
    } catch (const Error& error) {
        streams_.setNote(name, error.problem());
    }
}

void RobotBridge::sendGrid() {
    const GridKeeper& keeper = map_.isThere() ? map_ : costMap_;
    if (!keeper.isThere()) return;
    bool isKnown = false;
    const auto T_map_from_grid = toMap(keeper.frame(), isKnown);
    if (!isKnown) return;
    isGridWanted_ = false;
    tell_(keeper.grid(T_map_from_grid));
}

void RobotBridge::onPath(const PathMessage& message) {
    streams_.heard("trajectory", now_s_);
    bool isKnown = false;
    const auto T_map_from_path = toMap(message.frame, isKnown);
    if (!isKnown) return;
    try {
        Trajectory trajectory;
        for (const auto& pose : message.poses) {
            const Rows T_path_from_robot = rowsOfPose(pose, "trajectory");
            trajectory.T_map_from_robot.push_back(T_map_from_path ? product(*T_map_from_path, T_path_from_robot)
                                                                  : T_path_from_robot);
        }
        streams_.setNote("trajectory", "");
        tell_(std::move(trajectory));
    } catch (const Error& error) {
        streams_.setNote("trajectory", error.problem());
    }
}

// --- state and camera ------------------------------------------------------------------------------------------------

void RobotBridge::onTransforms() {
    streams_.heard("transforms", now_s_);
}

void RobotBridge::onOdometry(const OdometryMessage& message) {
    streams_.heard("odometry", now_s_);
    still_.onOdometry(message, now_s_);
    note(robot_.onStamp(message.stamp_ns, port_.now_ns(), now_s_));
}

void RobotBridge::chooseImageTransport() {
    const std::string& transport = parameters_.text("image_transport");
    const std::string base = parameters_.text("image");
    const auto isPublished = [this](const std::string& name) {
        return std::any_of(topics_.begin(), topics_.end(), [&](const Topic& topic) { return topic.name == name; });
    };
    bool compressed = transport == "compressed";
    if (transport == "auto") {
        compressed = isPublished(base + "/compressed");
        if (!compressed && !isPublished(base)) return;
    }
    if (isCompressed_ == compressed) return;
    isCompressed_ = compressed;
    streams_.setTopic("camera", compressed ? base + "/compressed" : base,
                      compressed ? "sensor_msgs/CompressedImage" : "sensor_msgs/Image");
    port_.watchImage(compressed);
}

void RobotBridge::onImage(const ImageMessage& message) {
    streams_.heard("camera", now_s_);
    photos_.onImage(message, now_s_);
}

void RobotBridge::onCameraInfo(const CameraInfoMessage& message) {
    streams_.heard("camera calibration", now_s_);
    streams_.setNote("camera calibration",
                     message.isDistorted ? "the lens distorts; outlines in photos are off towards the corners" : "");
    photos_.onCameraInfo(message);
}

void RobotBridge::onServiceAnswered(const ServiceAnswered& answer) {
    tell_(answer);
}

}  // namespace fodscope::bridge
