// SPDX-License-Identifier: MIT
#pragma once

#include <actionlib/server/action_server_base.h>
#include <actionlib/server/server_goal_handle.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/subscriber.h>

#include <functional>

#include "app/robot_simulator/ros/RobotClock.h"

namespace fodscope::robot_simulator {

/// actionlib's server for `move_base`, over topics that may fail: what it says is actionlib's, what is heard and sent
/// depends on the faults.
class ActionEndpoint : public actionlib::ActionServerBase<move_base_msgs::MoveBaseAction> {
  public:
    /// @param isLost asked for each goal that arrives from outside
    ActionEndpoint(ros::NodeHandle& node, const Faults& faults, const RobotClock& clock,
                   std::function<void(GoalHandle)> onGoal, std::function<void(GoalHandle)> onCancel,
                   std::function<bool()> isLost);

    void publishStatusWhenDue(double now_s);

  private:
    void initialize() override;
    void publishResult(const actionlib_msgs::GoalStatus& status, const Result& result) override;
    void publishFeedback(const actionlib_msgs::GoalStatus& status, const Feedback& feedback) override;
    void publishStatus() override;
    void hearGoal(const move_base_msgs::MoveBaseActionGoalConstPtr& goal);
    void hearCancel(const actionlib_msgs::GoalIDConstPtr& goalId);

    ros::NodeHandle node_;
    const Faults& faults_;
    const RobotClock& clock_;
    std::function<bool()> isLost_;
    double statusDue_s_ = 0.0;
    ros::Publisher result_;
    ros::Publisher feedback_;
    ros::Publisher status_;
    ros::Subscriber goal_;
    ros::Subscriber cancel_;
};

}  // namespace fodscope::robot_simulator
