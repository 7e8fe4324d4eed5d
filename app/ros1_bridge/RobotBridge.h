// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/ros1_bridge/GoalTracker.h"
#include "app/ros1_bridge/GridKeeper.h"
#include "app/ros1_bridge/HandDrive.h"
#include "app/ros1_bridge/MasterWatch.h"
#include "app/ros1_bridge/PhotoTaker.h"
#include "app/ros1_bridge/RobotWatch.h"
#include "app/ros1_bridge/RosPort.h"
#include "app/ros1_bridge/StandstillWatch.h"
#include "app/ros1_bridge/StreamTable.h"

namespace fodscope::bridge {

/// The bridge between the two languages: carries out what the workstation asks, and tells it what the robot says.
/// Time is an argument, and ROS stands behind an interface, so it can be tested without either.
class RobotBridge : private RosListener {
  public:
    using Tell = std::function<void(Event)>;

    /// @param port, parameters outlive it
    RobotBridge(RosPort& port, const ParameterValues& parameters, const Configure& configuration, Tell tell);

    void handle(const Request& request, double now_s);
    void onMaster(const MasterSighting& sighting, double now_s);
    /// Hears the robot out and does what is due. Call it a hundred times a second.
    void tick(double now_s);
    /// Whether the master was found once, so that ROS may be spoken to.
    bool isAttached() const { return masterProcess_.has_value(); }
    /// The workstation is gone: whoever drives by hand drives no more.
    void workstationLost();

  private:
    struct PendingGoal {
        SendGoal goal;
        double since_s = 0.0;
    };

    void carryOut(const Configure&) {}
    void carryOut(const FetchMap&);
    void carryOut(const FollowMap& request);
    void carryOut(const FetchGrid&);
    void carryOut(const SendGoal& goal);
    void carryOut(const CancelAllGoals&);
    void carryOut(const TakePhoto& request);
    void carryOut(const Drive& request);
    void carryOut(const CallService& request);
    void carryOut(const ListTopics&);

    void onCloud(const CloudMessage& message) override;
    void onGrid(const GridMessage& message, bool isCostMap) override;
    void onGridUpdate(const GridUpdateMessage& message, bool isCostMap) override;
    void onPath(const PathMessage& message) override;
    void onImage(const ImageMessage& message) override;
    void onCameraInfo(const CameraInfoMessage& message) override;
    void onOdometry(const OdometryMessage& message) override;
    void onTransforms() override;
    void onGoalStatus(const std::vector<GoalStatusMessage>& goals) override;
    void onGoalFeedback(const std::string&) override {}
    void onGoalResult(const GoalStatusMessage& result) override;
    void onServiceAnswered(const ServiceAnswered& answer) override;

    void note(const std::string& text);
    void tellOfGoal(Event event);
    void sendPendingGoal();
    void failPendingGoal(GoalProblem problem, const std::string& message);
    /// In the frame of the robot's cost map; missing where no transform leads there.
    std::optional<PlanarPose> inGoalFrame(const PlanarPose& pose_map) const;
    std::string goalFrame() const;
    void repeatCancel();
    void driveByHand();
    void watchMapRequest();
    void sendGrid();
    void chooseImageTransport();
    std::optional<Rows> toMap(const std::string& frame, bool& isKnown) const;
    State state() const;

    RosPort& port_;
    const ParameterValues& parameters_;
    std::string masterUri_;
    Tell tell_;
    double now_s_ = 0.0;

    bool masterAnswers_ = false;
    std::optional<int> masterProcess_;
    std::vector<Topic> topics_;
    std::optional<bool> isCompressed_;

    StreamTable streams_;
    RobotWatch robot_;
    StandstillWatch still_;
    PhotoTaker photos_;
    GoalTracker goals_;
    HandDrive hand_;
    GridKeeper map_{false};
    GridKeeper costMap_{true};
    std::optional<PendingGoal> pendingGoal_;
    std::optional<PlanarPose> goal_map_;
    bool followsMap_ = false;
    std::optional<double> mapAsked_s_;
    bool isGridWanted_ = false;
    double stateSent_s_ = -1e9;
    double streamsSent_s_ = -1e9;
};

}  // namespace fodscope::bridge
