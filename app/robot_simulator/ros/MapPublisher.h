// SPDX-License-Identifier: MIT
#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>
#include <std_srvs/Empty.h>

#include "app/robot_simulator/RobotModel.h"
#include "app/robot_simulator/ros/PublishMap.h"
#include "app/robot_simulator/ros/RobotClock.h"

namespace fodscope::robot_simulator {

/// RTAB-Map's side: cloud, grid and path of the map, and its services. All are latched, but the cloud is assembled only
/// while somebody subscribes: so it comes with the next update of the map, which takes motion, or when asked for.
class MapPublisher {
  public:
    MapPublisher(ros::NodeHandle& node, RobotModel& model, const Faults& faults, const RobotClock& clock);

    void step(double now_s);

  private:
    void offerServices();
    bool setMapping(bool on);
    bool publishMap(const PublishMap::Request& request);
    void sendGridAndPath();
    void sendCloudToSubscribers();

    ros::NodeHandle node_;
    RobotModel& model_;
    const Faults& faults_;
    const RobotClock& clock_;
    ros::Publisher cloud_;
    ros::Publisher grid_;
    /// The same under the name that the launch files give it.
    ros::Publisher map_;
    ros::Publisher path_;
    ros::ServiceServer setModeLocalization_;
    ros::ServiceServer setModeMapping_;
    ros::ServiceServer publishMap_;
    bool offered_ = false;
    double due_s_ = 0.0;
    std::uint64_t updatesSeen_ = 0;
    std::uint64_t versionSent_ = 0;
    std::uint64_t cloudVersionSent_ = 0;
};

}  // namespace fodscope::robot_simulator
