// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <future>
#include <memory>
#include <optional>

#include "app/robot_simulator/RobotModel.h"
#include "core/common/Progress.h"
#include "core/simulation/PhotoCamera.h"
#include "core/simulation/Raycaster.h"

namespace fodscope::robot_simulator {

/// The camera's frames, rendered one after the other off the caller's thread. A frame shows the world as it was when
/// it was exposed, however long its rendering takes. On the move frames are coarse, as moving pictures are; a robot
/// that stands is rendered once, and then only the sensor's noise differs from frame to frame.
class CameraFeed {
  public:
    CameraFeed(std::shared_ptr<const World> world, std::shared_ptr<const Raycaster> raycaster,
               const PhotoCameraSettings& camera, double rate_hz);
    ~CameraFeed();
    CameraFeed(const CameraFeed&) = delete;
    CameraFeed& operator=(const CameraFeed&) = delete;

    void advance(double now_s, const Pose2& robot_map, bool isStanding);
    void setWanted(bool wanted) { wanted_ = wanted; }
    std::optional<Picture> take();

    struct Still;
    struct Frame {
        Picture picture;
        std::shared_ptr<const Still> still;
    };

  private:
    void expose(double now_s, const Pose2& robot_map, bool isStanding);

    std::shared_ptr<const World> world_;
    std::shared_ptr<const Raycaster> raycaster_;
    PhotoCameraSettings camera_;
    double period_s_;
    bool wanted_ = false;
    double due_s_ = 0.0;
    std::uint64_t frames_ = 0;
    std::shared_ptr<const Still> still_;
    std::shared_ptr<Progress> progress_;
    std::future<Frame> rendering_;
};

}  // namespace fodscope::robot_simulator
