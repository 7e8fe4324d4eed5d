// SPDX-License-Identifier: MIT
#pragma once

#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/single_subscriber_publisher.h>

#include "app/robot_simulator/RobotModel.h"
#include "app/robot_simulator/ros/RobotClock.h"

namespace fodscope::robot_simulator {

/// The global cost map as costmap_2d publishes it: in full once to each new subscriber and when its shape changes, then
/// the rectangle in which something changed, or might have, round the robot.
class CostMapPublisher {
  public:
    CostMapPublisher(ros::NodeHandle& node, const RobotModel& model, const Faults& faults, const RobotClock& clock);

    void step(double now_s);

  private:
    struct Box {
        int left;
        int bottom;
        int right;
        int top;
    };

    void greet(const ros::SingleSubscriberPublisher& subscriber);
    nav_msgs::OccupancyGrid fullMessage() const;
    Box neighbourhood() const;
    void grow(Box& box, const PercentGrid& before) const;
    void sendUpdate(const Box& box);

    const RobotModel& model_;
    const Faults& faults_;
    const RobotClock& clock_;
    PercentGrid costMap_;
    std::uint64_t version_ = 0;
    double due_s_ = 0.0;
    ros::Publisher full_;
    ros::Publisher updates_;
};

}  // namespace fodscope::robot_simulator
