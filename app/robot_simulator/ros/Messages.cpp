// SPDX-License-Identifier: MIT
#include "app/robot_simulator/ros/Messages.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace fodscope::robot_simulator {
namespace {

constexpr std::uint32_t kPointStep = 32;
constexpr std::uint32_t kRgbOffset = 16;

sensor_msgs::PointField floatField(const char* name, std::uint32_t offset) {
    sensor_msgs::PointField field;
    field.name = name;
    field.offset = offset;
    field.datatype = sensor_msgs::PointField::FLOAT32;
    field.count = 1;
    return field;
}

void writePoint(std::uint8_t* at, const ColouredPoint& point) {
    std::memcpy(at, &point.x_m, sizeof(float));
    std::memcpy(at + 4, &point.y_m, sizeof(float));
    std::memcpy(at + 8, &point.z_m, sizeof(float));
    const std::uint32_t rgb = std::uint32_t{point.red} << 16 | std::uint32_t{point.green} << 8 | point.blue;
    std::memcpy(at + kRgbOffset, &rgb, sizeof(rgb));
}

/// Every third point, as a depth camera's holes come out of a cloud that keeps its order.
void writeHoles(sensor_msgs::PointCloud2& cloud) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    for (std::size_t point = 0; point < cloud.width; point += 3)
        for (std::size_t axis = 0; axis < 3; ++axis)
            std::memcpy(&cloud.data[point * kPointStep + 4 * axis], &kNan, sizeof(kNan));
    cloud.is_dense = false;
}

void apply(CloudFault fault, sensor_msgs::PointCloud2& cloud) {
    switch (fault) {
        case CloudFault::None:
        case CloudFault::Silent:
            return;
        case CloudFault::Nan:
            return writeHoles(cloud);
        case CloudFault::Empty:
            cloud.width = 0;
            cloud.row_step = 0;
            cloud.data.clear();
            return;
        case CloudFault::MissingFields:
            cloud.fields = {floatField("x", 0), floatField("y", 4), floatField("intensity", kRgbOffset)};
            return;
        case CloudFault::WrongRowStep:
            cloud.row_step += 13;
            return;
        case CloudFault::Truncated:
            cloud.data.resize(cloud.data.size() / 2);
            return;
    }
}

}  // namespace

geometry_msgs::Quaternion quaternionOf(double yaw_rad) {
    geometry_msgs::Quaternion q;
    q.z = std::sin(0.5 * yaw_rad);
    q.w = std::cos(0.5 * yaw_rad);
    return q;
}

geometry_msgs::Pose poseMessage(const PlanarPose& pose) {
    geometry_msgs::Pose message;
    message.position.x = pose.x_m;
    message.position.y = pose.y_m;
    message.orientation = quaternionOf(pose.yaw_rad);
    return message;
}

PlanarPose planarPose(const geometry_msgs::Pose& pose) {
    const geometry_msgs::Quaternion& q = pose.orientation;
    return {pose.position.x, pose.position.y,
            std::atan2(2.0 * (q.w * q.z + q.x * q.y), q.w * q.w + q.x * q.x - q.y * q.y - q.z * q.z)};
}

PlanarPose composed(const PlanarPose& frame, const PlanarPose& pose) {
    const double c = std::cos(frame.yaw_rad), s = std::sin(frame.yaw_rad);
    return {frame.x_m + c * pose.x_m - s * pose.y_m, frame.y_m + s * pose.x_m + c * pose.y_m,
            frame.yaw_rad + pose.yaw_rad};
}

PlanarPose relative(const PlanarPose& frame, const PlanarPose& pose) {
    const double c = std::cos(frame.yaw_rad), s = std::sin(frame.yaw_rad);
    const double dx = pose.x_m - frame.x_m, dy = pose.y_m - frame.y_m;
    return {c * dx + s * dy, c * dy - s * dx, pose.yaw_rad - frame.yaw_rad};
}

nav_msgs::OccupancyGrid gridMessage(const PercentGrid& grid, const ros::Time& stamp) {
    nav_msgs::OccupancyGrid message;
    message.header.frame_id = kMapFrame;
    message.header.stamp = stamp;
    message.info.map_load_time = stamp;
    message.info.resolution = static_cast<float>(grid.resolution_m);
    message.info.width = static_cast<std::uint32_t>(grid.width);
    message.info.height = static_cast<std::uint32_t>(grid.height);
    message.info.origin.position.x = grid.originX_map_m;
    message.info.origin.position.y = grid.originY_map_m;
    message.info.origin.orientation.w = 1.0;
    message.data.assign(grid.percent.begin(), grid.percent.end());
    return message;
}

sensor_msgs::PointCloud2 cloudMessage(const std::vector<ColouredPoint>& points, CloudFault fault,
                                      const ros::Time& stamp) {
    sensor_msgs::PointCloud2 cloud;
    cloud.header.frame_id = kMapFrame;
    cloud.header.stamp = stamp;
    cloud.height = 1;
    cloud.width = static_cast<std::uint32_t>(points.size());
    cloud.fields = {floatField("x", 0), floatField("y", 4), floatField("z", 8), floatField("rgb", kRgbOffset)};
    cloud.point_step = kPointStep;
    cloud.row_step = kPointStep * cloud.width;
    cloud.is_dense = true;
    cloud.data.resize(cloud.row_step);
    for (std::size_t i = 0; i < points.size(); ++i)
        writePoint(&cloud.data[i * kPointStep], points[i]);
    apply(fault, cloud);
    return cloud;
}

}  // namespace fodscope::robot_simulator
