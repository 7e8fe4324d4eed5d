// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// What the workstation and `fodscope-ros1-bridge` say to each other over the bridge's standard input and output.
///
/// On the wire a message is
///
///     "FSB1"            4 bytes, so that anything else on the pipe is noticed at once
///     length            4 bytes, little-endian: how many bytes follow; at most kGreatestMessage
///     body              CBOR (RFC 8949): a map whose entry "is" names the message and whose other entries are its
///                       fields, named as below. Absent optionals are left out. Poses are arrays [x, y, yaw],
///                       transforms arrays of 16 numbers, row-major. Points, cells, colours and photos are byte
///                       strings.
///
/// The workstation writes Requests, the bridge Events. The first request is Configure; before it the bridge says Hello
/// and nothing else. Unknown entries are ignored, so fields can be added within a version; an unknown message, a
/// missing field, a value of another type or out of its range is an error, and who reads it ends the conversation.
///
/// This header is C++17 and includes neither ROS nor Qt, so that both sides read the same text.
namespace fodscope::bridge {

/// Raised whenever a message changes its meaning or loses a field.
inline constexpr int kProtocolVersion = 1;
/// The largest message: a map of 40 million points with colours.
inline constexpr std::size_t kGreatestMessage = std::size_t{640} << 20;

/// Metres and radians, in the frame that the field's name tells.
struct PlanarPose {
    double x_m = 0.0;
    double y_m = 0.0;
    double yaw_rad = 0.0;
};

/// 4×4, row-major.
using Rows = std::array<double, 16>;
using Bytes = std::vector<std::uint8_t>;

// --- requests: workstation to bridge ---------------------------------------------------------------------------------

/// "configure": the first request.
struct Configure {
    int version = kProtocolVersion;
    /// ROS_MASTER_URI, e.g. "http://robot:11311".
    std::string masterUri;
    /// ROS_IP or ROS_HOSTNAME of this computer as the robot sees it; empty: found out by ROS.
    std::string ownAddress;
    /// Put before the ids of goals on the robot, so that two workstations, or one that was restarted, are told apart.
    std::string goalPrefix;
    /// Topics, frames, services and limits by name, see BridgeParameters.h; those that are missing have their defaults.
    std::map<std::string, std::string> parameters;
};
/// "fetch map": the next cloud that comes.
struct FetchMap {};
/// "follow map": every cloud that comes, or none any more.
struct FollowMap {
    bool on = false;
};
/// "fetch grid": the grid as it is now, all updates applied, or once it comes.
struct FetchGrid {};
/// "send goal"
struct SendGoal {
    std::string id;
    PlanarPose pose_map;
};
/// "cancel all goals": every goal on the robot, whoever sent it. Repeated by the bridge until none is under way.
struct CancelAllGoals {};
/// "take photo": the first frame exposed after the robot stands still.
struct TakePhoto {
    std::string requestId;
};
/// "drive": speeds that hold for 0.3 s and are then zero, unless the request is repeated. Held to the limits.
struct Drive {
    double forward_m_per_s = 0.0;
    double turn_rad_per_s = 0.0;
};
/// "call service": "set_mode_localization", "set_mode_mapping" or "publish_map". Never called unasked.
struct CallService {
    std::string service;
};
/// "list topics"
struct ListTopics {};

using Request = std::variant<Configure, FetchMap, FollowMap, FetchGrid, SendGoal, CancelAllGoals, TakePhoto, Drive,
                             CallService, ListTopics>;

// --- events: bridge to workstation -----------------------------------------------------------------------------------

/// "hello": what the bridge is, said at its start.
struct Hello {
    int version = kProtocolVersion;
    std::string program;
};

/// As numbers on the wire.
enum class Link : int { Connecting = 0, Connected = 1, Lost = 2 };

/// "state": some ten times a second, so that silence means that the bridge hangs. Ages in seconds when it was sent.
struct State {
    Link link = Link::Connecting;
    /// Why the link is not connected, in words; else empty.
    std::string reason;
    std::optional<PlanarPose> pose_map;
    /// Since the newest transform of the chain came.
    double poseAge_s = 0.0;
    /// What odometry says; missing while it is silent.
    std::optional<bool> moving;
    /// How long odometry has said that the robot stands.
    std::optional<double> stillFor_s;
    /// The goal under way, when it is one of this workstation.
    std::optional<std::string> goalId;
    /// Whether anybody's goal is under way on the robot.
    bool anyGoalUnderWay = false;
    std::optional<double> distanceLeft_m;
    /// How far the robot's clock is ahead of this computer's.
    std::optional<double> clockAhead_s;
};

struct Stream {
    /// "map cloud", "pose", …
    std::string name;
    std::string topic;
    std::string type;
    /// Since the last message; missing before the first.
    std::optional<double> age_s;
    /// Older than this is stale; 0: it comes when it comes.
    double staleAfter_s = 0.0;
    std::uint64_t count = 0;
    /// What is odd about it, in words.
    std::string note;
};
/// "streams": once a second.
struct Streams {
    std::vector<Stream> streams;
};

struct Topic {
    std::string name;
    std::string type;
};
/// "topics": what the master knows, sorted by type and name.
struct Topics {
    std::vector<Topic> topics;
};

/// "goal accepted": its id is in the action server's status.
struct GoalAccepted {
    std::string goalId;
};
/// "goal arrived"
struct GoalArrived {
    std::string goalId;
    std::optional<PlanarPose> pose_map;
};
/// As numbers on the wire.
enum class GoalProblem : int {
    Rejected = 0,
    Aborted = 1,
    Preempted = 2,
    NotAcknowledged = 3,
    LinkLost = 4,
    StopRequested = 5
};
/// "goal failed"
struct GoalFailed {
    std::string goalId;
    GoalProblem problem = GoalProblem::Aborted;
    std::string message;
};

/// "photo taken"
struct PhotoTaken {
    std::string requestId;
    /// The goal the robot reached last; empty before the first.
    std::string goalId;
    /// The camera's stamp, nanoseconds since 1970 on the robot's clock.
    std::int64_t stamp_ns = 0;
    /// Optical frame (z forward, x right, y down).
    Rows T_map_from_camera{};
    /// To be put into a map that moved later on; missing when it is not known.
    std::optional<Rows> T_odom_from_camera;
    int width_px = 0;
    int height_px = 0;
    double fx_px = 0.0;
    double fy_px = 0.0;
    double cx_px = 0.0;
    double cy_px = 0.0;
    /// JPEG or PNG as the camera sent it; raw pictures as PNG.
    Bytes picture;
};
/// As numbers on the wire.
enum class PhotoProblem : int { Missing = 0, Corrupt = 1, TimedOut = 2 };
/// "photo failed"
struct PhotoFailed {
    std::string requestId;
    PhotoProblem problem = PhotoProblem::Missing;
    std::string message;
};

/// "map cloud": finite points in the map frame.
struct MapCloud {
    /// x, y, z as little-endian float32, 12 bytes a point.
    Bytes points;
    /// Empty, or red, green, blue, 3 bytes a point.
    Bytes colours;
    /// Points that were left out because a coordinate was NaN or infinite.
    std::uint64_t dropped = 0;
    std::int64_t stamp_ns = 0;
};

/// "grid": nav_msgs/OccupancyGrid in the map frame, all updates applied.
struct Grid {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    double resolution_m = 0.0;
    PlanarPose origin_map;
    /// Row-major, one signed byte a cell: −1 unknown, 0 to 100.
    Bytes cells;
    /// A cost map of costmap_2d, where 100 is an obstacle, 99 and less its surroundings; else a map, where the value is
    /// the probability of an obstacle in percent.
    bool isCostMap = false;
};

/// "trajectory": poses the map was seen from.
struct Trajectory {
    std::vector<Rows> T_map_from_robot;
};

/// "service answered"
struct ServiceAnswered {
    std::string service;
    bool ok = false;
    std::string message;
};

/// "note": a sentence for the operator.
struct Note {
    std::string text;
};

using Event = std::variant<Hello, State, Streams, Topics, GoalAccepted, GoalArrived, GoalFailed, PhotoTaken,
                           PhotoFailed, MapCloud, Grid, Trajectory, ServiceAnswered, Note>;

}  // namespace fodscope::bridge
