// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/cloud/PointCloud.h"
#include "core/common/Geometry.h"
#include "core/planning/OccupancyGrid.h"
#include "core/robot/Photo.h"
#include "core/robot/RobotConsole.h"

namespace fodscope {

enum class LinkState { Disconnected, Connecting, Connected, Lost };
enum class GoalFailure { Rejected, Aborted, Preempted, NotAcknowledged, TimedOut, LinkLost, StopRequested };
enum class PhotoFailure { Missing, Corrupt, TimedOut, LinkLost };

std::string toString(LinkState state);
std::string toString(GoalFailure failure);
std::string toString(PhotoFailure failure);

/// What the link knows about the robot. Every value carries when it was measured, so that whoever shows it can show its
/// age.
struct RobotState {
    LinkState link = LinkState::Disconnected;
    std::optional<Pose2> pose_map;
    double poseMeasured_s = 0.0;
    bool moving = false;
    /// The goal under way, if any.
    std::optional<std::string> goalId;
    std::optional<double> distanceLeft_m;
    /// The robot's clock minus this computer's; empty while it is not known.
    std::optional<double> clockOffset_s;
};

/// A drive to one pose. Ids are unique within a session.
struct RobotGoal {
    std::string id;
    Pose2 pose_map;
};

struct RobotStateChanged {
    RobotState state;
};
/// The robot has confirmed that it works on the goal; sending alone is not acceptance.
struct GoalAccepted {
    std::string goalId;
};
struct GoalArrived {
    std::string goalId;
    Pose2 pose_map;
};
struct GoalFailed {
    std::string goalId;
    GoalFailure failure;
    std::string message;
};
/// `requestId` is the one that asked for it; id, waypoint and candidates of the photo are filled in by the receiver.
struct PhotoReceived {
    std::string requestId;
    Photo photo;
};
struct PhotoFailed {
    std::string requestId;
    PhotoFailure failure;
    std::string message;
};
struct MapReceived {
    std::shared_ptr<const PointCloud> map;
};
struct GridReceived {
    OccupancyGrid grid;
};
struct LinkMessage {
    std::string text;
};

using RobotEvent = std::variant<RobotStateChanged, GoalAccepted, GoalArrived, GoalFailed, PhotoReceived, PhotoFailed,
                                MapReceived, GridReceived, LinkMessage>;

/// All that a robot does for Fodscope passes through here. Requests return at once and are answered by events, which
/// the owner fetches with poll(): no call blocks and no callback arrives on a strange thread. Time is the caller's
/// monotonic clock in seconds, so that a simulated mission can run faster than real time and repeatably.
/// Implementations: the simulated robot (core/simulation) and the ROS 1 bridge.
class RobotLink {
  public:
    virtual ~RobotLink() = default;

    /// For the record, e.g. "simulated robot".
    virtual std::string name() const = 0;
    virtual void connect() = 0;
    virtual void disconnect() = 0;
    virtual void requestMap() = 0;
    virtual void requestGrid() = 0;
    virtual void sendGoal(const RobotGoal& goal) = 0;
    /// Cancels every goal on the robot, whoever sent it.
    virtual void cancelAllGoals() = 0;
    virtual void requestPhoto(const std::string& requestId) = 0;
    /// @return what happened since the last call, oldest first
    virtual std::vector<RobotEvent> poll(double now_s) = 0;
    /// What a robot offers beside visits; null for one that offers nothing else.
    virtual RobotConsole* console() { return nullptr; }
};

}  // namespace fodscope
