// SPDX-License-Identifier: MIT
#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <string>

#include "app/robot_simulator/RobotModel.h"
#include "app/robot_simulator/ros/ActionEndpoint.h"

namespace fodscope::robot_simulator {

/// The action server `move_base`: one goal at a time by the rules of actionlib's SimpleActionServer, answers in
/// move_base's words.
class MoveBaseServer {
  public:
    MoveBaseServer(ros::NodeHandle& node, RobotModel& model, const Faults& faults, const RobotClock& clock);

    void step(double now_s);

  private:
    using GoalHandle = ActionEndpoint::GoalHandle;

    void startServer();
    void stopServer();
    bool takesFault(GoalFault fault);
    void hearGoal(GoalHandle goal);
    void hearCancel(GoalHandle goal);
    bool isActive() const;
    void acceptNext(double now_s);
    void pursue(double now_s);
    void fail(double now_s);
    void tellFeedback(double now_s);
    void haveSomebodyElseSendAGoal();

    ros::NodeHandle node_;
    RobotModel& model_;
    const Faults& faults_;
    const RobotClock& clock_;
    ros::Publisher currentGoal_;
    std::unique_ptr<ActionEndpoint> endpoint_;
    double restart_s_ = 0.0;
    GoalHandle current_;
    GoalHandle next_;
    bool hasNew_ = false;
    bool cancelRequested_ = false;
    bool newCancelRequested_ = false;
    /// Of the goal under way.
    GoalFault fault_ = GoalFault::None;
    bool isStuck_ = false;
    GoalFault lastFault_ = GoalFault::None;
    int faultsTaken_ = 0;
    double feedbackDue_s_ = 0.0;
};

}  // namespace fodscope::robot_simulator
