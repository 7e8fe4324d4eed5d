// SPDX-License-Identifier: MIT
#include "app/robot_simulator/CameraFeed.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "core/common/Error.h"
#include "core/simulation/Random.h"

namespace fodscope::robot_simulator {

/// What the camera of a standing robot sees, before the noise of the single frame.
struct CameraFeed::Still {
    Pose2 robot_map;
    cv::Mat image;
};

namespace {

/// Frames on the move have this share of the rays in each direction.
constexpr int kCoarser = 4;

PhotoCameraSettings coarser(PhotoCameraSettings camera) {
    camera.width_px = std::max(1, camera.width_px / kCoarser);
    camera.height_px = std::max(1, camera.height_px / kCoarser);
    return camera;
}

cv::Mat decoded(const std::vector<std::byte>& jpeg) {
    const cv::Mat bytes(1, static_cast<int>(jpeg.size()), CV_8U, const_cast<std::byte*>(jpeg.data()));
    return cv::imdecode(bytes, cv::IMREAD_COLOR);
}

/// A grey level more or less: no two frames of a sensor are the same.
cv::Mat withNoise(const cv::Mat& image, std::uint64_t seed) {
    cv::RNG random(seed);
    cv::Mat brighter(image.size(), image.type()), darker(image.size(), image.type());
    random.fill(brighter, cv::RNG::UNIFORM, 0, 2);
    random.fill(darker, cv::RNG::UNIFORM, 0, 2);
    return image + brighter - darker;
}

Picture pictureOf(const cv::Mat& image, double exposed_s) {
    Picture picture;
    picture.exposed_s = exposed_s;
    picture.width_px = image.cols;
    picture.height_px = image.rows;
    if (!cv::imencode(".jpg", image, picture.jpeg, {cv::IMWRITE_JPEG_QUALITY, 92}))
        throw Error("camera", "a frame could not be written as JPEG", "install OpenCV with JPEG support");
    cv::Mat rgb;
    cv::cvtColor(image, rgb, cv::COLOR_BGR2RGB);
    picture.rgb.assign(rgb.datastart, rgb.dataend);
    return picture;
}

/// All that one frame needs, so that it can be made in a thread of its own.
struct Exposure {
    std::shared_ptr<const World> world;
    std::shared_ptr<const Raycaster> raycaster;
    PhotoCameraSettings camera;
    Pose2 robot_map;
    double exposed_s = 0.0;
    bool isStanding = false;
    std::uint64_t seed = 0;
    std::shared_ptr<const CameraFeed::Still> still;
    std::shared_ptr<Progress> progress;

    cv::Mat render() const {
        const Transform T_world_from_camera = world->T_map_from_world.inverse() * cameraPose(robot_map, camera);
        PhotoCameraSettings settings = isStanding ? camera : coarser(camera);
        settings.seed = seed;
        cv::Mat image = decoded(renderPhoto(*world, *raycaster, T_world_from_camera, settings, *progress));
        if (!isStanding) cv::resize(image, image, cv::Size(camera.width_px, camera.height_px), 0, 0, cv::INTER_CUBIC);
        return image;
    }

    CameraFeed::Frame develop() {
        if (!isStanding) return {pictureOf(render(), exposed_s), nullptr};
        if (!still || !(still->robot_map == robot_map))
            still = std::make_shared<CameraFeed::Still>(CameraFeed::Still{robot_map, render()});
        return {pictureOf(withNoise(still->image, seed), exposed_s), still};
    }
};

}  // namespace

CameraFeed::CameraFeed(std::shared_ptr<const World> world, std::shared_ptr<const Raycaster> raycaster,
                       const PhotoCameraSettings& camera, double rate_hz)
    : world_(std::move(world)), raycaster_(std::move(raycaster)), camera_(camera), period_s_(1.0 / rate_hz) {
    if (!(rate_hz > 0.0) || !std::isfinite(rate_hz))
        throw Error("camera", "the frame rate is not a positive number", "give frames a second, over 0");
    if (camera.width_px < 16 || camera.height_px < 16 || camera.width_px > 4096 || camera.height_px > 4096)
        throw Error("camera", "the image size is out of range", "give 16 to 4096 pixels");
}

CameraFeed::~CameraFeed() {
    if (progress_) progress_->cancel();
}

void CameraFeed::advance(double now_s, const Pose2& robot_map, bool isStanding) {
    if (!wanted_ || rendering_.valid() || now_s < due_s_) return;
    expose(now_s, robot_map, isStanding);
}

void CameraFeed::expose(double now_s, const Pose2& robot_map, bool isStanding) {
    due_s_ = now_s + period_s_;
    progress_ = std::make_shared<Progress>();
    Exposure exposure{world_, raycaster_, camera_, robot_map, now_s, isStanding, streamSeed(camera_.seed, ++frames_),
                      still_, progress_};
    rendering_ =
        std::async(std::launch::async, [exposure = std::move(exposure)]() mutable { return exposure.develop(); });
}

std::optional<Picture> CameraFeed::take() {
    if (!rendering_.valid() || rendering_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return std::nullopt;
    Frame frame = rendering_.get();
    if (frame.still) still_ = std::move(frame.still);
    return std::move(frame.picture);
}

}  // namespace fodscope::robot_simulator
