// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/ros1_bridge/Picture.h"
#include "app/ros1_bridge/RosPort.h"
#include "app/ros1_bridge/StandstillWatch.h"

namespace fodscope::bridge {

struct PhotoSettings {
    std::string mapFrame;
    std::string odomFrame;
    std::string imageTopic;
    std::string cameraInfoTopic;
    double photoTimeout_s = 8.0;
    double tfTimeout_s = 1.0;
};

/// Takes a photo: the first frame exposed after the robot stands still, with where the camera was at its exposure.
/// All times of frames, odometry and transforms are the robot's own, so the clocks of robot and workstation may differ.
class PhotoTaker {
  public:
    using Tell = std::function<void(Event)>;

    /// @param port, still outlive it
    PhotoTaker(PhotoSettings settings, const RosPort& port, const StandstillWatch& still, Tell tell);

    /// One photo at a time: a request takes the place of one that waits.
    void request(const std::string& requestId, const std::string& goalId, double now_s);
    void onCameraInfo(const CameraInfoMessage& message) { camera_ = message; }
    void onImage(const ImageMessage& message, double now_s);
    void onTick(double now_s);

  private:
    struct Waiting {
        std::string requestId;
        std::string goalId;
        double since_s = 0.0;
        /// Frames that came meanwhile and were exposed before the robot stood still.
        int earlyFrames = 0;
    };
    struct Exposed {
        Picture picture;
        std::string frame;
        std::int64_t stamp_ns = 0;
        double since_s = 0.0;
    };

    void deliver(double now_s);
    void fail(PhotoProblem problem, const std::string& message);
    std::string reasonForDelay(double now_s) const;
    bool isFrozen(const Rows& T_map_from_camera) const;
    bool requireCamera();

    PhotoSettings settings_;
    const RosPort& port_;
    const StandstillWatch& still_;
    Tell tell_;
    std::optional<CameraInfoMessage> camera_;
    std::optional<double> lastFrame_s_;
    std::optional<Waiting> waiting_;
    std::optional<Exposed> exposed_;
    /// The photo before, to notice a camera that sends one picture for ever.
    Bytes lastPicture_;
    Rows lastPose_{};
};

}  // namespace fodscope::bridge
