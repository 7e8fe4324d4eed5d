// SPDX-License-Identifier: MIT
#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Quaternion.h>
#include <nav_msgs/OccupancyGrid.h>
#include <sensor_msgs/PointCloud2.h>

#include <vector>

#include "app/robot_simulator/RobotModel.h"
#include "app/robot_simulator/ros/Faults.h"

namespace fodscope::robot_simulator {

inline constexpr const char* kMapFrame = "map";
inline constexpr const char* kOdomFrame = "odom";
inline constexpr const char* kBaseFrame = "base_footprint";

geometry_msgs::Quaternion quaternionOf(double yaw_rad);
geometry_msgs::Pose poseMessage(const PlanarPose& pose);
/// @return the heading of a pose whose quaternion is upright
PlanarPose planarPose(const geometry_msgs::Pose& pose);
/// @return `pose`, given in the frame that stands at `frame` in another one, in that other one
PlanarPose composed(const PlanarPose& frame, const PlanarPose& pose);
/// @return `pose` as seen from `frame`, both given in one frame
PlanarPose relative(const PlanarPose& frame, const PlanarPose& pose);

nav_msgs::OccupancyGrid gridMessage(const PercentGrid& grid, const ros::Time& stamp);
/// rtabmap's layout, which is PCL's PointXYZRGB: x, y, z and rgb in 32 bytes a point.
sensor_msgs::PointCloud2 cloudMessage(const std::vector<ColouredPoint>& points, CloudFault fault,
                                      const ros::Time& stamp);

}  // namespace fodscope::robot_simulator
