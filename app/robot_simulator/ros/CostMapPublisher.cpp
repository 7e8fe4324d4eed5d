// SPDX-License-Identifier: MIT
#include "app/robot_simulator/ros/CostMapPublisher.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/robot_simulator/ros/Messages.h"

namespace fodscope::robot_simulator {
namespace {

/// move_base's publish_frequency on the TurtleBot3.
constexpr double kPeriod_s = 0.2;
/// Half the side of the square that the obstacle layer writes anew.
constexpr double kNeighbourhood_m = 0.5;

bool sameShape(const PercentGrid& a, const PercentGrid& b) {
    return a.width == b.width && a.height == b.height && a.resolution_m == b.resolution_m &&
           a.originX_map_m == b.originX_map_m && a.originY_map_m == b.originY_map_m;
}

}  // namespace

CostMapPublisher::CostMapPublisher(ros::NodeHandle& node, const RobotModel& model, const Faults& faults,
                                   const RobotClock& clock)
    : model_(model), faults_(faults), clock_(clock), costMap_(model.costMap()), version_(model.mapVersion()) {
    full_ = node.advertise<nav_msgs::OccupancyGrid>(
        "move_base/global_costmap/costmap", 1,
        [this](const ros::SingleSubscriberPublisher& subscriber) { greet(subscriber); });
    updates_ = node.advertise<map_msgs::OccupancyGridUpdate>("move_base/global_costmap/costmap_updates", 1);
}

void CostMapPublisher::greet(const ros::SingleSubscriberPublisher& subscriber) {
    if (faults_.costMap != CostMapFault::Silent && costMap_.width > 0) subscriber.publish(fullMessage());
}

nav_msgs::OccupancyGrid CostMapPublisher::fullMessage() const {
    nav_msgs::OccupancyGrid message = gridMessage(costMap_, clock_.now());
    if (faults_.costMap == CostMapFault::WrongSize) message.data.resize(message.data.size() / 2);
    return message;
}

void CostMapPublisher::step(double now_s) {
    if (now_s < due_s_) return;
    due_s_ = now_s + kPeriod_s;
    PercentGrid before;
    const bool changed = model_.mapVersion() != version_;
    if (changed) {
        version_ = model_.mapVersion();
        before = std::exchange(costMap_, model_.costMap());
    }
    if (faults_.costMap == CostMapFault::Silent || costMap_.width == 0) return;
    if (changed && !sameShape(before, costMap_)) {
        full_.publish(fullMessage());
        return;
    }
    Box box = neighbourhood();
    if (changed) grow(box, before);
    if (box.left < box.right && box.bottom < box.top) sendUpdate(box);
}

CostMapPublisher::Box CostMapPublisher::neighbourhood() const {
    const PlanarPose robot = model_.pose_map();
    const auto cell = [&](double place_m, double origin_m, int size) {
        return std::clamp(static_cast<int>(std::floor((place_m - origin_m) / costMap_.resolution_m)), 0, size);
    };
    return {cell(robot.x_m - kNeighbourhood_m, costMap_.originX_map_m, costMap_.width),
            cell(robot.y_m - kNeighbourhood_m, costMap_.originY_map_m, costMap_.height),
            cell(robot.x_m + kNeighbourhood_m, costMap_.originX_map_m, costMap_.width),
            cell(robot.y_m + kNeighbourhood_m, costMap_.originY_map_m, costMap_.height)};
}

void CostMapPublisher::grow(Box& box, const PercentGrid& before) const {
    for (int row = 0; row < costMap_.height; ++row)
        for (int column = 0; column < costMap_.width; ++column) {
            const auto cell = static_cast<std::size_t>(row * costMap_.width + column);
            if (before.percent[cell] == costMap_.percent[cell]) continue;
            box = {std::min(box.left, column), std::min(box.bottom, row), std::max(box.right, column + 1),
                   std::max(box.top, row + 1)};
        }
}

void CostMapPublisher::sendUpdate(const Box& box) {
    map_msgs::OccupancyGridUpdate update;
    update.header.frame_id = kMapFrame;
    update.header.stamp = clock_.now();
    update.x = box.left;
    update.y = box.bottom;
    update.width = static_cast<std::uint32_t>(box.right - box.left);
    update.height = static_cast<std::uint32_t>(box.top - box.bottom);
    for (int row = box.bottom; row < box.top; ++row) {
        const auto begin = costMap_.percent.begin() + static_cast<std::ptrdiff_t>(row) * costMap_.width;
        update.data.insert(update.data.end(), begin + box.left, begin + box.right);
    }
    if (faults_.costMap == CostMapFault::UpdateOutside) update.x += costMap_.width;
    updates_.publish(update);
}

}  // namespace fodscope::robot_simulator
