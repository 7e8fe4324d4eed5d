// SPDX-License-Identifier: MIT
#include "app/robot_simulator/ros/MapPublisher.h"

#include <nav_msgs/Path.h>

#include "app/robot_simulator/ros/Messages.h"

namespace fodscope::robot_simulator {
namespace {

/// RTAB-Map's detection rate.
constexpr double kPeriod_s = 1.0;

}  // namespace

MapPublisher::MapPublisher(ros::NodeHandle& node, RobotModel& model, const Faults& faults, const RobotClock& clock)
    : node_(node),
      model_(model),
      faults_(faults),
      clock_(clock),
      cloud_(node.advertise<sensor_msgs::PointCloud2>("rtabmap/cloud_map", 1, true)),
      grid_(node.advertise<nav_msgs::OccupancyGrid>("rtabmap/grid_map", 1, true)),
      map_(node.advertise<nav_msgs::OccupancyGrid>("map", 1, true)),
      path_(node.advertise<nav_msgs::Path>("rtabmap/mapPath", 1, true)) {}

void MapPublisher::offerServices() {
    using Empty = std_srvs::Empty;
    setModeLocalization_ = node_.advertiseService<Empty::Request, Empty::Response>(
        "rtabmap/set_mode_localization", [this](Empty::Request&, Empty::Response&) { return setMapping(false); });
    setModeMapping_ = node_.advertiseService<Empty::Request, Empty::Response>(
        "rtabmap/set_mode_mapping", [this](Empty::Request&, Empty::Response&) { return setMapping(true); });

    publishMap_ = node_.advertiseService<PublishMap::Request, PublishMap::Response>(
        "rtabmap/publish_map",
        [this](PublishMap::Request& request, PublishMap::Response&) { return publishMap(request); });
}

void MapPublisher::step(double now_s) {
    const bool offered = faults_.services != ServiceFault::Missing;
    if (offered && !offered_) offerServices();
    if (!offered) setModeLocalization_ = setModeMapping_ = publishMap_ = ros::ServiceServer();
    offered_ = offered;

    if (now_s < due_s_) return;
    due_s_ = now_s + kPeriod_s;
    if (model_.mapVersion() != versionSent_) sendGridAndPath();
    if (model_.mapUpdates() == updatesSeen_) return;
    updatesSeen_ = model_.mapUpdates();
    if (model_.mapVersion() != cloudVersionSent_) sendCloudToSubscribers();
}

bool MapPublisher::setMapping(bool on) {
    if (faults_.services == ServiceFault::Failing) return false;
    model_.setMapping(on);
    return true;
}

bool MapPublisher::publishMap(const PublishMap::Request& request) {
    if (faults_.services == ServiceFault::Failing) return false;
    sendGridAndPath();
    if (!request.graphOnly) sendCloudToSubscribers();
    return true;
}

void MapPublisher::sendGridAndPath() {
    versionSent_ = model_.mapVersion();
    const ros::Time stamp = clock_.now();
    const nav_msgs::OccupancyGrid grid = gridMessage(model_.grid(), stamp);
    grid_.publish(grid);
    map_.publish(grid);

    nav_msgs::Path path;
    path.header.frame_id = kMapFrame;
    path.header.stamp = stamp;
    for (const PlanarPose& pose : model_.mapPath()) {
        geometry_msgs::PoseStamped stamped;
        stamped.header = path.header;
        stamped.pose = poseMessage(pose);
        path.poses.push_back(stamped);
    }
    path_.publish(path);
}

void MapPublisher::sendCloudToSubscribers() {
    if (cloud_.getNumSubscribers() == 0 || faults_.cloud == CloudFault::Silent) return;
    cloudVersionSent_ = model_.mapVersion();
    cloud_.publish(cloudMessage(model_.mapCloud(), faults_.cloud, clock_.now()));
}

}  // namespace fodscope::robot_simulator
