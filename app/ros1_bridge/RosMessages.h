// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// What the bridge reads of ROS messages, without ROS: C++17, for the files that include ROS headers and for those that
/// must not. Stamps are nanoseconds since 1970 on the robot's clock. Data is borrowed for the length of the call.
namespace fodscope::bridge {

struct DataView {
    const std::uint8_t* data = nullptr;
    std::size_t size = 0;
};

/// sensor_msgs/PointField; the types are numbered as there (1 int8 … 7 float32, 8 float64).
struct CloudField {
    std::string name;
    std::uint32_t offset = 0;
    std::uint8_t type = 0;
    std::uint32_t count = 1;
};

/// sensor_msgs/PointCloud2
struct CloudMessage {
    std::string frame;
    std::int64_t stamp_ns = 0;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t pointStep = 0;
    std::uint32_t rowStep = 0;
    bool isBigEndian = false;
    std::vector<CloudField> fields;
    DataView data;
};

/// nav_msgs/OccupancyGrid
struct GridMessage {
    std::string frame;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    double resolution_m = 0.0;
    /// Position x, y, z and orientation x, y, z, w of the corner of cell (0, 0).
    std::array<double, 7> origin{};
    DataView cells;
};

/// map_msgs/OccupancyGridUpdate
struct GridUpdateMessage {
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    DataView cells;
};

/// sensor_msgs/Image, or sensor_msgs/CompressedImage, where only frame, stamp, format (as encoding) and data are set.
struct ImageMessage {
    bool isCompressed = false;
    std::string frame;
    std::int64_t stamp_ns = 0;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t step = 0;
    std::string encoding;
    bool isBigEndian = false;
    DataView data;
};

/// sensor_msgs/CameraInfo
struct CameraInfoMessage {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    double fx_px = 0.0;
    double fy_px = 0.0;
    double cx_px = 0.0;
    double cy_px = 0.0;
    /// Whether a distortion coefficient is not zero.
    bool isDistorted = false;
};

/// nav_msgs/Odometry
struct OdometryMessage {
    std::int64_t stamp_ns = 0;
    double speed_m_per_s = 0.0;
    double turn_rad_per_s = 0.0;
};

/// actionlib_msgs/GoalStatus, numbered as there.
enum class ActionStatus : std::uint8_t {
    Pending = 0,
    Active = 1,
    Preempted = 2,
    Succeeded = 3,
    Aborted = 4,
    Rejected = 5,
    Preempting = 6,
    Recalling = 7,
    Recalled = 8,
    Lost = 9
};

struct GoalStatusMessage {
    std::string id;
    std::int64_t stamp_ns = 0;
    ActionStatus status = ActionStatus::Pending;
    std::string text;
};

/// nav_msgs/Path: position x, y, z and orientation x, y, z, w of every pose.
struct PathMessage {
    std::string frame;
    std::vector<std::array<double, 7>> poses;
};

}  // namespace fodscope::bridge
