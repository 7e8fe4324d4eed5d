// SPDX-License-Identifier: MIT
#include "app/robot_simulator/ros/MoveBaseServer.h"

#include <actionlib_msgs/GoalStatus.h>
#include <geometry_msgs/PoseStamped.h>

#include <cmath>

#include "app/robot_simulator/ros/Messages.h"

namespace fodscope::robot_simulator {
namespace {

using Result = move_base_msgs::MoveBaseResult;

constexpr double kFeedbackPeriod_s = 0.1;
constexpr double kRestartTakes_s = 1.0;
/// A fault on the way comes at this share of it.
constexpr double kHalfway = 0.5;
/// What SimpleActionServer says, its spelling included.
const std::string kSuperseded = "This goal was canceled because another goal was recieved by the simple action server";
const std::string kAccepted = "This goal has been accepted by the simple action server";
const std::string kNoPlan = "Failed to find a valid plan. Even after executing recovery behaviors.";
const std::string kInvalidQuaternion = "Aborting on goal because it was sent with an invalid quaternion";
/// Goals of this client are the simulator's own, no fault meets them.
const std::string kSomebodyElse = "/rviz-";

/// move_base's rule: finite, not zero and upright.
bool isUpright(const geometry_msgs::Quaternion& q) {
    const double norm = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    if (!std::isfinite(norm) || norm < 1e-3) return false;
    const double x = q.x / norm, y = q.y / norm;
    const double upwards = 1.0 - 2.0 * (x * x + y * y);
    return std::abs(upwards - 1.0) <= 1e-3;
}

}  // namespace

MoveBaseServer::MoveBaseServer(ros::NodeHandle& node, RobotModel& model, const Faults& faults, const RobotClock& clock)
    : node_(node),
      model_(model),
      faults_(faults),
      clock_(clock),
      currentGoal_(node.advertise<geometry_msgs::PoseStamped>("move_base/current_goal", 1)) {}

void MoveBaseServer::startServer() {
    endpoint_ = std::make_unique<ActionEndpoint>(
        node_, faults_, clock_, [this](GoalHandle goal) { hearGoal(goal); },
        [this](GoalHandle goal) { hearCancel(goal); }, [this] { return takesFault(GoalFault::Lost); });
    endpoint_->start();
}

/// As when its process ends: nobody is told, and it knows no goal afterwards.
void MoveBaseServer::stopServer() {
    if (!endpoint_) return;
    if (isActive()) model_.stop();
    current_ = GoalHandle();
    next_ = GoalHandle();
    hasNew_ = cancelRequested_ = newCancelRequested_ = false;
    endpoint_.reset();
}

void MoveBaseServer::step(double now_s) {
    if (faults_.goal != lastFault_) {
        lastFault_ = faults_.goal;
        faultsTaken_ = 0;
    }
    if (faults_.goal == GoalFault::NoServer) stopServer();
    if (!endpoint_ && faults_.goal != GoalFault::NoServer && now_s >= restart_s_) startServer();
    if (!endpoint_) return;
    if (isActive() && cancelRequested_ && !hasNew_) {
        model_.stop();
        current_.setCanceled(Result(), "");
    }
    if (hasNew_) acceptNext(now_s);
    if (isActive()) pursue(now_s);
    if (endpoint_) endpoint_->publishStatusWhenDue(now_s);
}

/// @return whether this fault is set and still has a goal to hit; that one is then counted
bool MoveBaseServer::takesFault(GoalFault fault) {
    if (faults_.goal != fault || (faults_.goalTimes > 0 && faultsTaken_ >= faults_.goalTimes)) return false;
    ++faultsTaken_;
    return true;
}

void MoveBaseServer::hearGoal(GoalHandle goal) {
    if (takesFault(GoalFault::Rejected)) {
        goal.setRejected(Result(), "This goal was rejected");
        return;
    }
    const auto isEarlierThan = [&](GoalHandle& other) {
        return other.getGoal() && goal.getGoalID().stamp < other.getGoalID().stamp;
    };
    if (isEarlierThan(current_) || isEarlierThan(next_)) {
        goal.setCanceled(Result(), kSuperseded);
        return;
    }
    if (next_.getGoal() && (!current_.getGoal() || next_ != current_)) next_.setCanceled(Result(), kSuperseded);
    next_ = goal;
    hasNew_ = true;
    newCancelRequested_ = false;
    if (isActive()) cancelRequested_ = true;
}

void MoveBaseServer::hearCancel(GoalHandle goal) {
    if (goal == current_)
        cancelRequested_ = true;
    else if (goal == next_)
        newCancelRequested_ = true;
}

bool MoveBaseServer::isActive() const {
    if (!current_.getGoal()) return false;
    const auto status = current_.getGoalStatus().status;
    return status == actionlib_msgs::GoalStatus::ACTIVE || status == actionlib_msgs::GoalStatus::PREEMPTING;
}

void MoveBaseServer::acceptNext(double now_s) {
    if (isActive() && current_ != next_) current_.setCanceled(Result(), kSuperseded);
    model_.stop();
    current_ = next_;
    hasNew_ = false;
    cancelRequested_ = newCancelRequested_;
    newCancelRequested_ = false;
    isStuck_ = false;
    fault_ = GoalFault::None;
    current_.setAccepted(kAccepted);
    if (current_.getGoalID().id.rfind(kSomebodyElse, 0) != 0) {
        for (const GoalFault fault :
             {GoalFault::Aborted, GoalFault::Preempted, GoalFault::NeverArrives, GoalFault::ServerRestarts})
            if (takesFault(fault)) fault_ = fault;
    }

    const geometry_msgs::PoseStamped& target = current_.getGoal()->target_pose;
    if (!isUpright(target.pose.orientation)) {
        current_.setAborted(Result(), kInvalidQuaternion);
        return;
    }
    currentGoal_.publish(target);
    PlanarPose goal_map = planarPose(target.pose);
    // As move_base does: what cannot be transformed is taken as it is.
    if (target.header.frame_id == kOdomFrame) goal_map = composed(model_.start_map(), goal_map);
    const bool isPlace = std::isfinite(goal_map.x_m) && std::isfinite(goal_map.y_m);
    if (!isPlace || !model_.driveTo(goal_map)) current_.setAborted(Result(), kNoPlan);
    feedbackDue_s_ = now_s;
}

void MoveBaseServer::pursue(double now_s) {
    tellFeedback(now_s);
    if (isStuck_) return;
    if (fault_ != GoalFault::None && model_.drivenShare() >= kHalfway) {
        fail(now_s);
    } else if (!model_.isDriving()) {
        current_.setSucceeded(Result(), "Goal reached.");
    }
}

void MoveBaseServer::fail(double now_s) {
    const GoalFault fault = fault_;
    fault_ = GoalFault::None;
    switch (fault) {
        case GoalFault::Aborted:
            model_.stop();
            current_.setAborted(Result(), kNoPlan);
            return;
        case GoalFault::Preempted:
            haveSomebodyElseSendAGoal();
            return;
        case GoalFault::NeverArrives:
            model_.stop();
            isStuck_ = true;
            return;
        case GoalFault::ServerRestarts:
            stopServer();
            restart_s_ = now_s + kRestartTakes_s;
            return;
        default:
            return;
    }
}

void MoveBaseServer::tellFeedback(double now_s) {
    if (now_s < feedbackDue_s_) return;
    feedbackDue_s_ = now_s + kFeedbackPeriod_s;
    move_base_msgs::MoveBaseFeedback feedback;
    feedback.base_position.header.frame_id = kMapFrame;
    feedback.base_position.header.stamp = clock_.now();
    feedback.base_position.pose = poseMessage(model_.pose_map());
    current_.publishFeedback(feedback);
}

/// A goal back to the start, as from somebody with RViz.
void MoveBaseServer::haveSomebodyElseSendAGoal() {
    move_base_msgs::MoveBaseActionGoal goal;
    goal.header.stamp = clock_.now();
    goal.goal_id.stamp = std::max(goal.header.stamp, current_.getGoalID().stamp);
    goal.goal_id.id = kSomebodyElse + std::to_string(goal.header.stamp.toNSec());
    goal.goal.target_pose.header.frame_id = kMapFrame;
    goal.goal.target_pose.header.stamp = goal.header.stamp;
    goal.goal.target_pose.pose = poseMessage(model_.start_map());
    endpoint_->goalCallback(boost::make_shared<const move_base_msgs::MoveBaseActionGoal>(goal));
}

}  // namespace fodscope::robot_simulator
