// SPDX-License-Identifier: MIT
#include "app/robot_simulator/ros/RobotNode.h"

#include <geometry_msgs/Twist.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include "app/robot_simulator/ros/CameraPublisher.h"
#include "app/robot_simulator/ros/CostMapPublisher.h"
#include "app/robot_simulator/ros/Faults.h"
#include "app/robot_simulator/ros/FramePublisher.h"
#include "app/robot_simulator/ros/MapPublisher.h"
#include "app/robot_simulator/ros/MasterWatch.h"
#include "app/robot_simulator/ros/MoveBaseServer.h"
#include "app/robot_simulator/ros/NodeParameters.h"
#include "app/robot_simulator/ros/RobotClock.h"

namespace fodscope::robot_simulator {
namespace {

constexpr double kStep_s = 0.02;

class RobotNode {
  public:
    RobotNode(ros::NodeHandle node, const ros::NodeHandle& privateNode, std::unique_ptr<RobotModel> model)
        : node_(std::move(node)),
          faultSource_(privateNode),
          faults_(faultSource_.read()),
          clock_(faults_),
          model_(std::move(model)),
          frames_(node_, *model_, faults_, clock_),
          camera_(node_, *model_, faults_, clock_),
          map_(node_, *model_, faults_, clock_),
          costMap_(node_, *model_, faults_, clock_),
          moveBase_(node_, *model_, faults_, clock_),
          velocity_(node_.subscribe("cmd_vel", 1, &RobotNode::hearVelocity, this)) {}

    /// @return where the robot stands when it is to begin again under another master; empty at the end
    std::optional<PlanarPose> run() {
        while (ros::ok()) {
            if (master_.isAnotherMaster()) return model_->pose_map();
            ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(kStep_s));
            const double now_s = ros::SteadyTime::now().toSec();
            if (now_s < due_s_) continue;
            due_s_ = now_s + kStep_s;
            step(now_s);
        }
        return std::nullopt;
    }

  private:
    void step(double now_s) {
        readFaults();
        model_->advance(now_s);
        moveBase_.step(now_s);
        frames_.step(now_s);
        camera_.step();
        map_.step(now_s);
        costMap_.step(now_s);
    }

    /// One that is misspelt while the robot runs is told once and changes nothing.
    void readFaults() {
        try {
            faults_ = faultSource_.read();
            problem_.clear();
        } catch (const std::runtime_error& problem) {
            if (problem_ != problem.what()) ROS_ERROR("%s", problem.what());
            problem_ = problem.what();
        }
    }

    void hearVelocity(const geometry_msgs::Twist::ConstPtr& twist) {
        model_->command({twist->linear.x, twist->angular.z});
    }

    ros::NodeHandle node_;
    MasterWatch master_;
    FaultSource faultSource_;
    Faults faults_;
    RobotClock clock_;
    std::unique_ptr<RobotModel> model_;
    FramePublisher frames_;
    CameraPublisher camera_;
    MapPublisher map_;
    CostMapPublisher costMap_;
    MoveBaseServer moveBase_;
    ros::Subscriber velocity_;
    double due_s_ = 0.0;
    std::string problem_;
};

}  // namespace

std::optional<std::vector<std::string>> runRobotNode(std::vector<std::string> arguments, ModelSettings settings) {
    std::vector<char*> argv;
    for (std::string& argument : arguments)
        argv.push_back(argument.data());
    int argc = static_cast<int>(argv.size());
    argv.push_back(nullptr);
    ros::init(argc, argv.data(), "robot_simulator");
    ros::NodeHandle node;
    const ros::NodeHandle privateNode("~");
    settings = withParameters(std::move(settings), privateNode);
    ROS_INFO("making the world '%s'%s", settings.world.c_str(), settings.mapped ? " and its map" : "");
    RobotNode robot(node, privateNode, makeRobotModel(settings));
    ROS_INFO("the robot is ready");
    settings.start_map = robot.run();
    if (!settings.start_map) return std::nullopt;
    ROS_WARN("another master answers: the robot begins again");
    ros::shutdown();
    for (std::string& parameter : parameterArguments(settings))
        arguments.push_back(std::move(parameter));
    return arguments;
}

}  // namespace fodscope::robot_simulator
