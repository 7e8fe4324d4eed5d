// SPDX-License-Identifier: MIT
#include "app/ros1_bridge/PhotoTaker.h"

#include <cmath>
#include <utility>

#include "core/common/Error.h"

namespace fodscope::bridge {
namespace {

/// Farther apart than this, two pictures cannot be the same.
constexpr double kMoved_m = 0.05;
constexpr double kTurned = 0.05;

bool isElsewhere(const Rows& first, const Rows& second) {
    double distance = 0.0;
    double turn = 0.0;
    for (const std::size_t row : {0u, 4u, 8u}) {
        distance = std::max(distance, std::abs(first[row + 3] - second[row + 3]));
        for (std::size_t column = 0; column < 3; ++column)
            turn = std::max(turn, std::abs(first[row + column] - second[row + column]));
    }
    return distance > kMoved_m || turn > kTurned;
}

std::string sizeText(std::int64_t width, std::int64_t height) {
    return std::to_string(width) + " × " + std::to_string(height);
}

std::string secondsText(double seconds) {
    return std::to_string(static_cast<int>(std::lround(seconds))) + " s";
}

}  // namespace

PhotoTaker::PhotoTaker(PhotoSettings settings, const RosPort& port, const StandstillWatch& still, Tell tell)
    : settings_(std::move(settings)), port_(port), still_(still), tell_(std::move(tell)) {}

void PhotoTaker::request(const std::string& requestId, const std::string& goalId, double now_s) {
    waiting_ = Waiting{requestId, goalId, now_s, 0};
    exposed_.reset();
}

void PhotoTaker::onImage(const ImageMessage& message, double now_s) {
    lastFrame_s_ = now_s;
    if (!waiting_ || exposed_) return;
    const auto stillSince_ns = still_.stillSince_ns(now_s);
    if (!stillSince_ns) return;
    if (message.stamp_ns <= *stillSince_ns) {
        ++waiting_->earlyFrames;
        return;
    }
    try {
        exposed_ = Exposed{pictureOf(message), message.frame, message.stamp_ns, now_s};
    } catch (const Error& error) {
        fail(PhotoProblem::Corrupt, error.problem());
        return;
    }
    deliver(now_s);
}

void PhotoTaker::onTick(double now_s) {
    if (!waiting_) return;
    if (exposed_) {
        deliver(now_s);
    } else if (now_s - waiting_->since_s >= settings_.photoTimeout_s) {
        fail(PhotoProblem::TimedOut, reasonForDelay(now_s));
    }
}

void PhotoTaker::deliver(double now_s) {
    const bool isLate = now_s - exposed_->since_s >= settings_.tfTimeout_s;
    const auto T_map_from_camera = port_.lookup(settings_.mapFrame, exposed_->frame, exposed_->stamp_ns);
    if (!T_map_from_camera) {
        if (isLate)
            fail(PhotoProblem::Missing, "where the photo was taken is not known: no transform from " +
                                            settings_.mapFrame + " to " + exposed_->frame + " at its time");
        return;
    }
    if (!camera_) {
        if (isLate) fail(PhotoProblem::Missing, "nothing came from " + settings_.cameraInfoTopic);
        return;
    }
    if (!requireCamera()) return;
    if (isFrozen(T_map_from_camera->T_target_from_source)) {
        fail(PhotoProblem::Corrupt, "the camera is frozen: it sends the same picture as at the place before");
        return;
    }
    PhotoTaken photo;
    photo.requestId = waiting_->requestId;
    photo.goalId = waiting_->goalId;
    photo.stamp_ns = exposed_->stamp_ns;
    photo.T_map_from_camera = T_map_from_camera->T_target_from_source;
    const auto T_odom_from_camera = port_.lookup(settings_.odomFrame, exposed_->frame, exposed_->stamp_ns);
    if (T_odom_from_camera) photo.T_odom_from_camera = T_odom_from_camera->T_target_from_source;
    photo.width_px = exposed_->picture.width_px;
    photo.height_px = exposed_->picture.height_px;
    photo.fx_px = camera_->fx_px;
    photo.fy_px = camera_->fy_px;
    photo.cx_px = camera_->cx_px;
    photo.cy_px = camera_->cy_px;
    photo.picture = std::move(exposed_->picture.bytes);
    lastPicture_ = photo.picture;
    lastPose_ = photo.T_map_from_camera;
    waiting_.reset();
    exposed_.reset();
    tell_(std::move(photo));
}

bool PhotoTaker::requireCamera() {
    const bool isCalibrated = std::isfinite(camera_->fx_px) && camera_->fx_px > 0.0 && std::isfinite(camera_->fy_px) &&
                              camera_->fy_px > 0.0 && std::isfinite(camera_->cx_px) && std::isfinite(camera_->cy_px);
    if (!isCalibrated) {
        fail(PhotoProblem::Missing, settings_.cameraInfoTopic + " has no calibration");
        return false;
    }
    const Picture& picture = exposed_->picture;
    if (std::cmp_not_equal(picture.width_px, camera_->width) ||
        std::cmp_not_equal(picture.height_px, camera_->height)) {
        fail(PhotoProblem::Missing, "the calibration is for pictures of " + sizeText(camera_->width, camera_->height) +
                                        ", the photo has " + sizeText(picture.width_px, picture.height_px));
        return false;
    }
    return true;
}

bool PhotoTaker::isFrozen(const Rows& T_map_from_camera) const {
    return !lastPicture_.empty() && isElsewhere(T_map_from_camera, lastPose_) &&
           exposed_->picture.bytes == lastPicture_;
}

void PhotoTaker::fail(PhotoProblem problem, const std::string& message) {
    const std::string requestId = waiting_->requestId;
    waiting_.reset();
    exposed_.reset();
    tell_(PhotoFailed{requestId, problem, message});
}

std::string PhotoTaker::reasonForDelay(double now_s) const {
    if (!lastFrame_s_) return "no picture has come from " + settings_.imageTopic + " yet";
    const double silent_s = now_s - *lastFrame_s_;
    if (silent_s > 0.5 * settings_.photoTimeout_s)
        return "no picture has come from " + settings_.imageTopic + " for " + secondsText(silent_s);
    const auto moving = still_.isMoving(now_s);
    if (!moving) return "odometry is silent, so nobody knows whether the robot stands still";
    if (*moving) return "odometry says that the robot does not stand still";
    return "the pictures that come were taken before the robot stood still: the camera is frozen, or its clock is not "
           "the robot's";
}

}  // namespace fodscope::bridge
