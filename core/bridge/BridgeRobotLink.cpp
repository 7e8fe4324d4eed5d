// SPDX-License-Identifier: MIT
#include "core/bridge/BridgeRobotLink.h"

#include <cstdlib>
#include <random>
#include <set>
#include <utility>

#include "core/bridge/BridgeParameters.h"
#include "core/bridge/BridgeSupervisor.h"
#include "core/bridge/EventConversion.h"
#include "core/common/Error.h"

namespace fodscope::bridge {
namespace {

constexpr const char* kProgram = "fodscope-ros1-bridge";
constexpr const char* kBridgeGone = "the connection to the robot was lost";

std::filesystem::path bridgeBesideThisProgram() {
    std::error_code problem;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", problem);
    return problem ? std::filesystem::path(kProgram) : self.parent_path() / kProgram;
}

std::string usualMasterUri() {
    const char* given = std::getenv("ROS_MASTER_URI");
    return given != nullptr && *given != '\0' ? given : "http://localhost:11311";
}

/// Another one for every workstation that starts.
std::string freshGoalPrefix() {
    constexpr const char* kDigits = "0123456789abcdef";
    std::random_device random;
    std::string prefix = "fodscope-";
    for (int i = 0; i < 8; ++i)
        prefix += kDigits[random() % 16];
    return prefix + "/";
}

const char* nameOf(RobotService service) {
    switch (service) {
        case RobotService::LocalizationMode:
            return "set_mode_localization";
        case RobotService::MappingMode:
            return "set_mode_mapping";
        case RobotService::PublishMap:
            return "publish_map";
    }
    return "";
}

class BridgeRobotLink : public RobotLink, public RobotConsole {
  public:
    BridgeRobotLink(SupervisorSettings settings, std::string masterUri)
        : settings_(std::move(settings)), masterUri_(std::move(masterUri)) {}

    std::string name() const override { return "ROS 1 robot at " + masterUri_; }
    void connect() override;
    void disconnect() override;
    void requestMap() override { ask(FetchMap{}); }
    void requestGrid() override;
    void sendGoal(const RobotGoal& goal) override;
    void cancelAllGoals() override { ask(CancelAllGoals{}); }
    void requestPhoto(const std::string& requestId) override;
    std::vector<RobotEvent> poll(double now_s) override;
    RobotConsole* console() override { return this; }

    const std::vector<RobotStream>& streams() const override { return streams_; }
    void requestTopics() override { ask(ListTopics{}); }
    const std::vector<RobotTopic>& topics() const override { return topics_; }
    const std::vector<Transform>& trajectory_map() const override { return trajectory_map_; }
    const std::string& problem() const override { return problem_; }
    std::optional<bool> isMoving() const override { return state_.moving; }
    std::optional<double> stillFor_s() const override { return state_.stillFor_s; }
    bool isAnyGoalUnderWay() const override { return state_.anyGoalUnderWay; }
    void drive(double forward_m_per_s, double turn_rad_per_s) override { ask(Drive{forward_m_per_s, turn_rad_per_s}); }
    void followMap(bool on) override;
    void callService(RobotService service) override { ask(CallService{nameOf(service)}); }

    int processId() const { return supervisor_ ? static_cast<int>(supervisor_->processId()) : 0; }

  private:
    bool isUp() const { return isGreeted_; }
    void ask(Request request) {
        if (supervisor_) supervisor_->send(std::move(request));
    }
    void say(RobotEvent event) { events_.push_back(std::move(event)); }
    void lose(const std::string& trouble);

    void take(Hello event);
    void take(State event);
    void take(Streams event);
    void take(Topics event);
    void take(bridge::GoalAccepted event) { say(fodscope::GoalAccepted{event.goalId}); }
    void take(bridge::GoalArrived event);
    void take(bridge::GoalFailed event);
    void take(PhotoTaken event);
    void take(bridge::PhotoFailed event);
    void take(MapCloud event) { say(MapReceived{pointCloudOf(event)}); }
    void take(Grid event) { say(GridReceived{occupancyGridOf(event)}); }
    void take(Trajectory event);
    void take(ServiceAnswered event);
    void take(Note event) { say(LinkMessage{event.text}); }

    SupervisorSettings settings_;
    std::string masterUri_;
    std::unique_ptr<BridgeSupervisor> supervisor_;
    std::vector<RobotEvent> events_;
    bool isGreeted_ = false;
    bool isGridWanted_ = false;
    bool followsMap_ = false;
    /// Asked of the bridge that runs, and not answered yet.
    std::set<std::string> goals_;
    std::set<std::string> photos_;
    /// When what is being read arrived, and the caller's time.
    double arrivedAgo_s_ = 0.0;
    double now_s_ = 0.0;
    State state_;
    std::string problem_ = "not connected";
    std::vector<RobotStream> streams_;
    std::vector<RobotTopic> topics_;
    std::vector<Transform> trajectory_map_;
};

void BridgeRobotLink::connect() {
    if (!supervisor_) supervisor_ = std::make_unique<BridgeSupervisor>(settings_);
    problem_ = "connecting";
}

void BridgeRobotLink::disconnect() {
    supervisor_.reset();
    isGreeted_ = false;
    problem_ = "not connected";
    RobotState state;
    state.link = LinkState::Disconnected;
    say(RobotStateChanged{state});
}

void BridgeRobotLink::requestGrid() {
    isGridWanted_ = true;
    if (isUp()) ask(FetchGrid{});
}

void BridgeRobotLink::sendGoal(const RobotGoal& goal) {
    if (!isUp()) return say(fodscope::GoalFailed{goal.id, GoalFailure::LinkLost, kBridgeGone});
    goals_.insert(goal.id);
    ask(SendGoal{goal.id, {goal.pose_map.x_m, goal.pose_map.y_m, goal.pose_map.yaw_rad}});
}

void BridgeRobotLink::requestPhoto(const std::string& requestId) {
    if (!isUp()) return say(fodscope::PhotoFailed{requestId, PhotoFailure::LinkLost, kBridgeGone});
    photos_.insert(requestId);
    ask(TakePhoto{requestId});
}

void BridgeRobotLink::followMap(bool on) {
    followsMap_ = on;
    ask(FollowMap{on});
}

std::vector<RobotEvent> BridgeRobotLink::poll(double now_s) {
    now_s_ = now_s;
    if (supervisor_) {
        for (BridgeSupervisor::Arrival& arrival : supervisor_->take()) {
            arrivedAgo_s_ = std::chrono::duration<double>(BridgeSupervisor::Clock::now() - arrival.when).count();
            if (!arrival.event) {
                lose(arrival.trouble);
                continue;
            }
            try {
                std::visit([this](auto& event) { take(std::move(event)); }, *arrival.event);
            } catch (const Error& error) {
                say(LinkMessage{error.what()});
            }
        }
    }
    return std::exchange(events_, {});
}

void BridgeRobotLink::lose(const std::string& trouble) {
    isGreeted_ = false;
    problem_ = "the bridge to the robot is gone (" + trouble + "); it is started again";
    say(LinkMessage{problem_});
    for (const std::string& goal : std::exchange(goals_, {}))
        say(fodscope::GoalFailed{goal, GoalFailure::LinkLost, kBridgeGone});
    for (const std::string& photo : std::exchange(photos_, {}))
        say(fodscope::PhotoFailed{photo, PhotoFailure::LinkLost, kBridgeGone});
    state_ = {};
    RobotState state;
    state.link = LinkState::Lost;
    say(RobotStateChanged{state});
}

void BridgeRobotLink::take(Hello) {
    isGreeted_ = true;
    if (isGridWanted_) ask(FetchGrid{});
    if (followsMap_) ask(FollowMap{true});
}

void BridgeRobotLink::take(State event) {
    state_ = std::move(event);
    problem_ = state_.reason;
    say(RobotStateChanged{robotStateOf(state_, arrivedAgo_s_, now_s_)});
}

void BridgeRobotLink::take(Streams event) {
    streams_.clear();
    for (Stream& each : event.streams) {
        std::optional<double> heard_s;
        if (each.age_s) heard_s = now_s_ - arrivedAgo_s_ - *each.age_s;
        streams_.push_back({std::move(each.name), std::move(each.topic), std::move(each.type), heard_s,
                            each.staleAfter_s, each.count, std::move(each.note)});
    }
}

void BridgeRobotLink::take(Topics event) {
    topics_.clear();
    for (Topic& each : event.topics)
        topics_.push_back({std::move(each.name), std::move(each.type)});
}

void BridgeRobotLink::take(bridge::GoalArrived event) {
    goals_.erase(event.goalId);
    const PlanarPose pose = event.pose_map.value_or(PlanarPose{});
    say(fodscope::GoalArrived{event.goalId, {pose.x_m, pose.y_m, pose.yaw_rad}});
}

void BridgeRobotLink::take(bridge::GoalFailed event) {
    goals_.erase(event.goalId);
    say(fodscope::GoalFailed{event.goalId, failureOf(event.problem), event.message});
}

void BridgeRobotLink::take(PhotoTaken event) {
    const std::string requestId = event.requestId;
    photos_.erase(requestId);
    try {
        say(PhotoReceived{requestId, photoOf(std::move(event))});
    } catch (const Error& error) {
        say(fodscope::PhotoFailed{requestId, PhotoFailure::Corrupt, error.problem()});
    }
}

void BridgeRobotLink::take(bridge::PhotoFailed event) {
    photos_.erase(event.requestId);
    say(fodscope::PhotoFailed{event.requestId, failureOf(event.problem), event.message});
}

void BridgeRobotLink::take(Trajectory event) {
    std::vector<Transform> poses;
    for (const Rows& rows : event.T_map_from_robot)
        poses.push_back(transformFromRows(rows, "trajectory of the robot"));
    trajectory_map_ = std::move(poses);
}

void BridgeRobotLink::take(ServiceAnswered event) {
    say(LinkMessage{event.ok ? "the robot did it: " + event.service : event.message});
}

}  // namespace

std::unique_ptr<RobotLink> makeBridgeRobot(const BridgeRobotSettings& settings) {
    // Checked here, where people can mend it, and once more by the bridge.
    ParameterValues{settings.parameters};
    SupervisorSettings supervisor;
    supervisor.program = settings.program.empty() ? bridgeBesideThisProgram() : settings.program;
    if (!std::filesystem::exists(supervisor.program))
        throw Error(supervisor.program.string(), "the ROS 1 bridge is not there",
                    "install it, or connect to the simulated robot");
    supervisor.configuration.masterUri = settings.masterUri.empty() ? usualMasterUri() : settings.masterUri;
    supervisor.configuration.ownAddress = settings.ownAddress;
    supervisor.configuration.goalPrefix = freshGoalPrefix();
    supervisor.configuration.parameters = settings.parameters;
    supervisor.silentAfter_s = settings.silentAfter_s;
    const std::string masterUri = supervisor.configuration.masterUri;
    return std::make_unique<BridgeRobotLink>(std::move(supervisor), masterUri);
}

int bridgeProcessId(const RobotLink& robot) {
    const auto* bridged = dynamic_cast<const BridgeRobotLink*>(&robot);
    return bridged != nullptr ? bridged->processId() : 0;
}

bool isBridgeInstalled() {
    return std::filesystem::exists(bridgeBesideThisProgram());
}

}  // namespace fodscope::bridge
