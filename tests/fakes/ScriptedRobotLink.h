// SPDX-License-Identifier: MIT
#pragma once

#include <opencv2/imgcodecs.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/robot/RobotLink.h"

namespace fodscope {

/// A small photo that a robot might send, ".jpg" or ".png"; each number gives another one.
inline std::vector<std::byte> photoBytes(const std::string& extension = ".jpg", int number = 0) {
    cv::Mat image(24, 32, CV_8UC3);
    for (int row = 0; row < image.rows; ++row) {
        for (int column = 0; column < image.cols; ++column)
            image.at<cv::Vec3b>(row, column) =
                cv::Vec3b(static_cast<unsigned char>(40 + 3 * row), static_cast<unsigned char>(90 + 4 * column),
                          static_cast<unsigned char>((160 + 29 * number) % 256));
    }
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
    std::vector<RobotEvent> poll(double now_s) override {
        for (RobotEvent& event : events) {
            if (auto* changed = std::get_if<RobotStateChanged>(&event)) changed->state.poseMeasured_s = now_s;
        }
        return keepsEvents && goals.empty() ? std::vector<RobotEvent>() : std::exchange(events, {});
    }

    /// Comes with the next poll.
    template <typename Event>
    void say(Event event) {
        events.emplace_back(std::move(event));
    }
    void accept() { say(GoalAccepted{goals.back().id}); }
    void arrive() {
        say(GoalArrived{goals.back().id, goals.back().pose_map});
        if (hasReported) report(LinkState::Connected);
    }
    void fail(GoalFailure failure, const std::string& message = "") {
        say(GoalFailed{goals.back().id, failure, message});
    }
    void sendPhoto() { sendPhoto(photoRequests.back(), photoBytes(".jpg", ++photosSent)); }
    void sendPhoto(const std::string& requestId, std::vector<std::byte> bytes) {
        Photo photo;
        photo.bytes = std::move(bytes);
        photo.taken = UtcTime::now();
        if (!goals.empty()) photo.T_map_from_camera = transformFromPose(goals.back().pose_map);
        say(PhotoReceived{requestId, std::move(photo)});
    }
    void report(LinkState link, const std::string& goalId = "", bool moving = false) {
        hasReported = true;
        RobotState state;
        state.link = link;
        state.moving = moving;
        if (!goals.empty()) state.pose_map = goals.back().pose_map;
        if (!goalId.empty()) state.goalId = goalId;
        say(RobotStateChanged{state});
    }

    std::vector<RobotGoal> goals;
    std::vector<std::string> photoRequests;
    int cancels = 0;
    int photosSent = 0;
    bool hasReported = false;
    /// Says nothing before the first goal.
    bool keepsEvents = false;
    std::vector<RobotEvent> events;
};

}  // namespace fodscope
