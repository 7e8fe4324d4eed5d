// SPDX-License-Identifier: MIT
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <sensor_msgs/CameraInfo.h>

#include <optional>

#include "app/robot_simulator/RobotModel.h"
#include "app/robot_simulator/ros/RobotClock.h"

namespace fodscope::robot_simulator {

/// The colour camera's topics, raw, compressed and camera_info, as realsense2_camera and image_transport name them.
class CameraPublisher {
  public:
    CameraPublisher(ros::NodeHandle& node, RobotModel& model, const Faults& faults, const RobotClock& clock);

    void step();

  private:
    Picture withFault(Picture picture);
    void send(const Picture& picture);
    void sendRaw(const Picture& picture, const std_msgs::Header& header);
    void sendCompressed(const Picture& picture, const std_msgs::Header& header);

    RobotModel& model_;
    const Faults& faults_;
    const RobotClock& clock_;
    ros::Publisher raw_;
    ros::Publisher compressed_;
    ros::Publisher info_;
    sensor_msgs::CameraInfo infoMessage_;
    /// What a camera that froze shows since then.
    std::optional<Picture> frozen_;
};

}  // namespace fodscope::robot_simulator
