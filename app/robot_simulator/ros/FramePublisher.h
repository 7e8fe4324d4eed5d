// SPDX-License-Identifier: MIT
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include "app/robot_simulator/RobotModel.h"
#include "app/robot_simulator/ros/RobotClock.h"

namespace fodscope::robot_simulator {

/// /tf, /tf_static and /odom: map → odom → base_footprint → base_link → camera_link → camera_color_frame →
/// camera_color_optical_frame (REP 103, REP 105, REP 120).
class FramePublisher {
  public:
    FramePublisher(ros::NodeHandle& node, const RobotModel& model, const Faults& faults, const RobotClock& clock);

    void step(double now_s);

  private:
    PlanarPose odomInMap() const;
    void sendFrames(const PlanarPose& base_odom);
    void sendOdometry(const PlanarPose& base_odom);

    const RobotModel& model_;
    const Faults& faults_;
    const RobotClock& clock_;
    tf2_ros::TransformBroadcaster frames_;
    tf2_ros::StaticTransformBroadcaster fixedFrames_;
    ros::Publisher odometry_;
    double due_s_ = 0.0;
};

}  // namespace fodscope::robot_simulator
