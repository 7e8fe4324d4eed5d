// SPDX-License-Identifier: MIT
#include "app/robot_simulator/ros/ActionEndpoint.h"

#include <actionlib_msgs/GoalStatusArray.h>

#include <utility>

namespace fodscope::robot_simulator {
namespace {

/// actionlib's defaults.
constexpr std::uint32_t kQueue = 50;
constexpr double kStatusPeriod_s = 0.2;

}  // namespace

ActionEndpoint::ActionEndpoint(ros::NodeHandle& node, const Faults& faults, const RobotClock& clock,
                               std::function<void(GoalHandle)> onGoal, std::function<void(GoalHandle)> onCancel,
                               std::function<bool()> isLost)
    : ActionServerBase(std::move(onGoal), std::move(onCancel)),
      node_(node, "move_base"),
      faults_(faults),
      clock_(clock),
      isLost_(std::move(isLost)) {
    status_list_timeout_ = ros::Duration(5.0);
}

void ActionEndpoint::initialize() {
    result_ = node_.advertise<ActionResult>("result", kQueue);
    feedback_ = node_.advertise<ActionFeedback>("feedback", kQueue);
    status_ = node_.advertise<actionlib_msgs::GoalStatusArray>("status", kQueue, true);
    goal_ = node_.subscribe("goal", kQueue, &ActionEndpoint::hearGoal, this);
    cancel_ = node_.subscribe("cancel", kQueue, &ActionEndpoint::hearCancel, this);
}

void ActionEndpoint::hearGoal(const move_base_msgs::MoveBaseActionGoalConstPtr& goal) {
    if (!isLost_()) goalCallback(goal);
}

void ActionEndpoint::hearCancel(const actionlib_msgs::GoalIDConstPtr& goalId) {
    if (faults_.goal != GoalFault::CancelLost) cancelCallback(goalId);
}

void ActionEndpoint::publishResult(const actionlib_msgs::GoalStatus& status, const Result& result) {
    ActionResult message;
    message.header.stamp = clock_.now();
    message.status = status;
    message.result = result;
    if (faults_.goal != GoalFault::ResultLost) result_.publish(message);
    publishStatus();
}

void ActionEndpoint::publishFeedback(const actionlib_msgs::GoalStatus& status, const Feedback& feedback) {
    ActionFeedback message;
    message.header.stamp = clock_.now();
    message.status = status;
    message.feedback = feedback;
    feedback_.publish(message);
}

/// A goal that is over stays in the list for some seconds, so that a lost result can be made up for.
void ActionEndpoint::publishStatus() {
    actionlib_msgs::GoalStatusArray message;
    message.header.stamp = clock_.now();
    for (auto tracker = status_list_.begin(); tracker != status_list_.end();) {
        message.status_list.push_back(tracker->status_);
        const bool isOver = tracker->handle_destruction_time_ != ros::Time() &&
                            tracker->handle_destruction_time_ + status_list_timeout_ < ros::Time::now();
        tracker = isOver ? status_list_.erase(tracker) : std::next(tracker);
    }
    status_.publish(message);
}

void ActionEndpoint::publishStatusWhenDue(double now_s) {
    if (now_s < statusDue_s_) return;
    statusDue_s_ = now_s + kStatusPeriod_s;
    publishStatus();
}

}  // namespace fodscope::robot_simulator
