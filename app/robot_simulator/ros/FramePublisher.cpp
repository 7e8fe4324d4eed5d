// SPDX-License-Identifier: MIT
#include "app/robot_simulator/ros/FramePublisher.h"

#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Odometry.h>

#include <cmath>
#include <vector>

#include "app/robot_simulator/ros/Messages.h"

namespace fodscope::robot_simulator {
namespace {

constexpr double kPeriod_s = 1.0 / 30.0;
/// Of a TurtleBot3 Waffle Pi.
constexpr double kBaseLinkHeight_m = 0.010;

geometry_msgs::TransformStamped transform(const char* parent, const char* child, const ros::Time& stamp) {
    geometry_msgs::TransformStamped message;
    message.header.frame_id = parent;
    message.header.stamp = stamp;
    message.child_frame_id = child;
    message.transform.rotation.w = 1.0;
    return message;
}

geometry_msgs::TransformStamped transform(const char* parent, const char* child, const PlanarPose& pose,
                                          const ros::Time& stamp) {
    geometry_msgs::TransformStamped message = transform(parent, child, stamp);
    message.transform.translation.x = pose.x_m;
    message.transform.translation.y = pose.y_m;
    message.transform.rotation = quaternionOf(pose.yaw_rad);
    return message;
}

std::vector<geometry_msgs::TransformStamped> fixedTransforms(const CameraShape& camera, const ros::Time& stamp) {
    auto baseLink = transform(kBaseFrame, "base_link", stamp);
    baseLink.transform.translation.z = kBaseLinkHeight_m;
    auto mount = transform("base_link", "camera_link", stamp);
    mount.transform.translation.z = camera.height_m - kBaseLinkHeight_m;
    // A positive turn about y (left) looks down.
    mount.transform.rotation.y = std::sin(0.5 * camera.pitchDown_rad);
    mount.transform.rotation.w = std::cos(0.5 * camera.pitchDown_rad);
    const auto lens = transform("camera_link", "camera_color_frame", stamp);
    // z forward, x right, y down.
    auto optical = transform("camera_color_frame", "camera_color_optical_frame", stamp);
    optical.transform.rotation.x = -0.5;
    optical.transform.rotation.y = 0.5;
    optical.transform.rotation.z = -0.5;
    optical.transform.rotation.w = 0.5;
    return {baseLink, mount, lens, optical};
}

}  // namespace

FramePublisher::FramePublisher(ros::NodeHandle& node, const RobotModel& model, const Faults& faults,
                               const RobotClock& clock)
    : model_(model), faults_(faults), clock_(clock), odometry_(node.advertise<nav_msgs::Odometry>("odom", 10)) {
    fixedFrames_.sendTransform(fixedTransforms(model.camera(), clock.now()));
}

void FramePublisher::step(double now_s) {
    if (now_s < due_s_) return;
    due_s_ = now_s + kPeriod_s;
    const PlanarPose base_odom = relative(model_.start_map(), model_.pose_map());
    if (faults_.tf != TfFault::Stale) sendFrames(base_odom);
    if (faults_.odometry != OdometryFault::Silent) sendOdometry(base_odom);
}

/// The odometry of the simulated robot does not drift: its frame stays where the robot started.
PlanarPose FramePublisher::odomInMap() const {
    PlanarPose odom_map = model_.start_map();
    if (faults_.tf == TfFault::Jumped) {
        odom_map.x_m += faults_.tfJumpX_m;
        odom_map.y_m += faults_.tfJumpY_m;
        odom_map.yaw_rad += faults_.tfJumpYaw_rad;
    }
    return odom_map;
}

void FramePublisher::sendFrames(const PlanarPose& base_odom) {
    const ros::Time stamp = clock_.now();
    std::vector<geometry_msgs::TransformStamped> frames{transform(kOdomFrame, kBaseFrame, base_odom, stamp)};
    if (faults_.tf != TfFault::Missing) frames.push_back(transform(kMapFrame, kOdomFrame, odomInMap(), stamp));
    frames_.sendTransform(frames);
}

void FramePublisher::sendOdometry(const PlanarPose& base_odom) {
    nav_msgs::Odometry message;
    message.header.frame_id = kOdomFrame;
    message.header.stamp = clock_.now();
    message.child_frame_id = kBaseFrame;
    message.pose.pose = poseMessage(base_odom);
    const Velocity velocity = model_.velocity();
    message.twist.twist.linear.x = velocity.forward_m_per_s;
    message.twist.twist.angular.z = velocity.turn_rad_per_s;
    odometry_.publish(message);
}

}  // namespace fodscope::robot_simulator
