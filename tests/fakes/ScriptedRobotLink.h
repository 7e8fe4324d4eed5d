// SPDX-License-Identifier: MIT
#pragma once

#include <opencv2/imgcodecs.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/robot/RobotLink.h"

namespace fodscope {

/// A small photo that a robot might send, ".jpg" or ".png".
inline std::vector<std::byte> photoBytes(const std::string& extension = ".jpg") {
    const cv::Mat image(24, 32, CV_8UC3, cv::Scalar(40, 90, 160));
    std::vector<unsigned char> encoded;
    cv::imencode(extension, image, encoded);
    const auto* first = reinterpret_cast<const std::byte*>(encoded.data());
    return {first, first + encoded.size()};
}

/// A link that says what the test makes it say, and keeps what it was asked.
class ScriptedRobotLink : public RobotLink {
  public:
    std::string name() const override { return "scripted robot"; }
    void connect() override {}
    void disconnect() override {}
    void requestMap() override {}
    void requestGrid() override {}
    void sendGoal(const RobotGoal& goal) override { goals.push_back(goal); }
    void cancelAllGoals() override { ++cancels; }
    void requestPhoto(const std::string& requestId) override { photoRequests.push_back(requestId); }
    std::vector<RobotEvent> poll(double) override { return std::exchange(events, {}); }

    /// Comes with the next poll.
    template <typename Event>
    void say(Event event) {
        events.emplace_back(std::move(event));
    }
    void accept() { say(GoalAccepted{goals.back().id}); }
    void arrive() { say(GoalArrived{goals.back().id, goals.back().pose_map}); }
    void fail(GoalFailure failure, const std::string& message = "") {
        say(GoalFailed{goals.back().id, failure, message});
    }
    void sendPhoto() { sendPhoto(photoRequests.back(), photoBytes()); }
    void sendPhoto(const std::string& requestId, std::vector<std::byte> bytes) {
        Photo photo;
        photo.bytes = std::move(bytes);
        say(PhotoReceived{requestId, std::move(photo)});
    }
    void report(LinkState link, const std::string& goalId = "", bool moving = false) {
        RobotState state;
        state.link = link;
        state.moving = moving;
        if (!goalId.empty()) state.goalId = goalId;
        say(RobotStateChanged{state});
    }

    std::vector<RobotGoal> goals;
    std::vector<std::string> photoRequests;
    int cancels = 0;
    std::vector<RobotEvent> events;
};

}  // namespace fodscope
