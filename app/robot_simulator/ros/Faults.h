// SPDX-License-Identifier: MIT
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <string>

namespace fodscope::robot_simulator {

enum class GoalFault {
    None,
    Lost,
    Rejected,
    Aborted,
    Preempted,
    NeverArrives,
    ServerRestarts,
    NoServer,
    ResultLost,
    CancelLost
};
enum class TfFault { None, Missing, Stale, Jumped };
enum class CameraFault { None, Silent, Frozen, Black, Corrupt, WrongEncoding, Huge };
enum class CloudFault { None, Silent, Nan, Empty, MissingFields, WrongRowStep, Truncated };
enum class CostMapFault { None, Silent, WrongSize, UpdateOutside };
enum class ServiceFault { None, Missing, Failing };
enum class OdometryFault { None, Silent };

/// What is wrong with the robot at the moment. Each stream has at most one fault; their names and what they do are in
/// the manual, under "Trying it on one machine".
struct Faults {
    GoalFault goal = GoalFault::None;
    /// How many goals the fault hits from the moment it is set; 0: every one.
    int goalTimes = 0;
    TfFault tf = TfFault::None;
    double tfJumpX_m = 0.5;
    double tfJumpY_m = 0.0;
    double tfJumpYaw_rad = 0.2;
    /// The robot's clock is ahead of this machine's by so much.
    double clockOffset_s = 0.0;
    CameraFault camera = CameraFault::None;
    CloudFault cloud = CloudFault::None;
    CostMapFault costMap = CostMapFault::None;
    ServiceFault services = ServiceFault::None;
    OdometryFault odometry = OdometryFault::None;
};

/// The parameters `~faults/...`, which may be changed at any time (`rosparam set`). While no master answers they stay
/// as they were.
class FaultSource {
  public:
    explicit FaultSource(const ros::NodeHandle& privateNode);

    /// Tells on the latched topic `~faults_in_effect` when they have become others, as NAME=VALUE words.
    /// @throws std::runtime_error with one sentence for an unknown fault or value
    Faults read();

  private:
    void tell(const std::string& inEffect);

    ros::NodeHandle node_;
    ros::Publisher inEffect_;
    std::string told_;
};

}  // namespace fodscope::robot_simulator
