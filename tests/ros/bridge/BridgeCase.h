// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/bridge/BridgeRobotLink.h"
#include "core/robot/VisitRunner.h"
#include "tests/ros/bridge/Programs.h"

namespace fodscope {

/// A robot that can be made to fail, and the workstation's link to it through the real bridge and a real roscore.
/// Core and robot are shared by the tests of a program; each test begins with a robot without faults.
class BridgeCase : public ::testing::Test {
  protected:
    static void SetUpTestSuite() {
        if (!rosIsMissing().empty()) return;
        core_ = std::make_unique<RosCore>();
        robot_ = std::make_unique<Program>(
            std::vector<std::string>{"/usr/bin/python3", fakesFolder() + "/faulty_robot.py"}, core_->environment());
        if (robot_->waitForEvent("ready").is_null()) throw std::runtime_error("the robot did not start");
    }
    static void TearDownTestSuite() {
        robot_.reset();
        core_.reset();
    }

    void SetUp() override {
        if (const std::string reason = rosIsMissing(); !reason.empty()) GTEST_SKIP() << reason;
        order(
            R"({"goals": "succeed", "tf": "ok", "jump": 0, "clock": 0, "odometry": "ok", "camera": "ok", "cloud": "ok"})");
    }

    static double now_s() {
        return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    }

    /// To the robot, which answers when it is done.
    static void order(const std::string& line) {
        robot_->writeLine(line);
        ASSERT_FALSE(robot_->waitForEvent("done").is_null()) << line;
    }

    static bridge::BridgeRobotSettings settings() {
        bridge::BridgeRobotSettings settings;
        settings.masterUri = core_->uri();
        settings.ownAddress = "127.0.0.1";
        settings.program = FODSCOPE_BRIDGE_PROGRAM;
        settings.parameters = {{"photo_timeout", "2.0"}, {"map_timeout", "2.0"}, {"lost_after", "1.5"}};
        return settings;
    }

    void connect() { connect(settings()); }
    void connect(const bridge::BridgeRobotSettings& settings) {
        link_ = bridge::makeBridgeRobot(settings);
        link_->connect();
    }
    /// Connected, the pose known, and everything heard once.
    void connectFully() {
        connect();
        ASSERT_TRUE(waitFor([this] {
            return state_ && state_->link == LinkState::Connected && state_->pose_map && isHeard("navigation") &&
                   isHeard("camera") && isHeard("odometry") && isHeard("camera calibration");
        })) << link_->console()->problem();
    }

    bool isHeard(const std::string& stream) const {
        for (const RobotStream& each : link_->console()->streams())
            if (each.name == stream) return each.heard_s.has_value();
        return false;
    }

    /// Polls, and measures how long that keeps the caller, until the condition holds.
    bool waitFor(const std::function<bool()>& holds, double within_s = 20.0) {
        const double deadline_s = now_s() + within_s;
        while (!holds()) {
            if (now_s() > deadline_s) return false;
            poll();
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        return true;
    }

    void poll() {
        const double before_s = now_s();
        if (runner_) {
            const VisitProgress progress = runner_->advance(before_s);
            if (progress.robot) state_ = progress.robot;
            photos_.insert(photos_.end(), progress.photos.begin(), progress.photos.end());
            messages_.insert(messages_.end(), progress.messages.begin(), progress.messages.end());
        } else {
            for (RobotEvent& event : link_->poll(before_s))
                take(event);
        }
        longestPoll_s_ = std::max(longestPoll_s_, now_s() - before_s);
    }

    template <class Event>
    const Event* last() const {
        for (auto event = events_.rbegin(); event != events_.rend(); ++event)
            if (const auto* found = std::get_if<Event>(&*event)) return found;
        return nullptr;
    }
    template <class Event>
    bool waitForEvent(double within_s = 20.0) {
        return waitFor([this] { return last<Event>() != nullptr; }, within_s);
    }
    bool hasMessage(const std::string& part) const {
        for (const std::string& message : messages_)
            if (message.find(part) != std::string::npos) return true;
        return false;
    }

    /// A plan of waypoints a little apart from each other.
    void startVisits(int count, VisitSettings settings = {}) {
        VisitPlan plan;
        std::vector<Visit> visits;
        for (int i = 0; i < count; ++i) {
            Waypoint waypoint;
            waypoint.id = "W-0" + std::to_string(i + 1);
            waypoint.candidateIds = {"C-00" + std::to_string(i + 1)};
            waypoint.pose_map = Pose2{0.4 * (i + 1), i % 2 == 0 ? 0.3 : -0.3, 0.5 * i};
            plan.waypoints.push_back(waypoint);
            Visit visit;
            visit.waypointId = waypoint.id;
            visits.push_back(visit);
        }
        runner_ = std::make_unique<VisitRunner>(*link_, plan, visits, settings);
        runner_->start();
    }
    const Visit& visit(std::size_t index) const { return runner_->visits()[index]; }
    bool waitForRunner(RunnerState state, double within_s = 30.0) {
        return waitFor([&] { return runner_->state() == state; }, within_s);
    }

    static std::unique_ptr<RosCore> core_;
    static std::unique_ptr<Program> robot_;
    std::unique_ptr<RobotLink> link_;
    std::unique_ptr<VisitRunner> runner_;
    std::optional<RobotState> state_;
    std::vector<RobotEvent> events_;
    std::vector<Photo> photos_;
    std::vector<std::string> messages_;
    double longestPoll_s_ = 0.0;

  private:
    void take(RobotEvent& event) {
        if (const auto* changed = std::get_if<RobotStateChanged>(&event)) {
            state_ = changed->state;
            return;
        }
        if (const auto* text = std::get_if<LinkMessage>(&event)) messages_.push_back(text->text);
        events_.push_back(std::move(event));
    }
};

}  // namespace fodscope
