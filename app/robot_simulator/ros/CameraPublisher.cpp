// SPDX-License-Identifier: MIT
#include "app/robot_simulator/ros/CameraPublisher.h"

#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/image_encodings.h>

#include <utility>

#include "app/robot_simulator/PictureFaults.h"

namespace fodscope::robot_simulator {
namespace {

constexpr const char* kTopic = "camera/color/image_raw";
constexpr const char* kFrame = "camera_color_optical_frame";
/// What a broken header claims: a row more than any JPEG can have would be refused at once.
constexpr std::uint32_t kHuge_px = 65500;

sensor_msgs::CameraInfo infoOf(const CameraShape& camera) {
    sensor_msgs::CameraInfo info;
    info.width = static_cast<std::uint32_t>(camera.width_px);
    info.height = static_cast<std::uint32_t>(camera.height_px);
    info.distortion_model = "plumb_bob";
    info.D.assign(5, 0.0);
    info.K = {camera.fx_px, 0.0, camera.cx_px, 0.0, camera.fy_px, camera.cy_px, 0.0, 0.0, 1.0};
    info.R = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
    info.P = {camera.fx_px, 0.0, camera.cx_px, 0.0, 0.0, camera.fy_px, camera.cy_px, 0.0, 0.0, 0.0, 1.0, 0.0};
    return info;
}

}  // namespace

CameraPublisher::CameraPublisher(ros::NodeHandle& node, RobotModel& model, const Faults& faults,
                                 const RobotClock& clock)
    : model_(model),
      faults_(faults),
      clock_(clock),
      raw_(node.advertise<sensor_msgs::Image>(kTopic, 2)),
      compressed_(node.advertise<sensor_msgs::CompressedImage>(std::string(kTopic) + "/compressed", 2)),
      info_(node.advertise<sensor_msgs::CameraInfo>("camera/color/camera_info", 2)),
      infoMessage_(infoOf(model.camera())) {}

void CameraPublisher::step() {
    model_.setCameraWanted(raw_.getNumSubscribers() + compressed_.getNumSubscribers() + info_.getNumSubscribers() > 0);
    if (std::optional<Picture> picture = model_.takePicture()) send(withFault(std::move(*picture)));
}

Picture CameraPublisher::withFault(Picture picture) {
    if (faults_.camera != CameraFault::Frozen) frozen_.reset();
    switch (faults_.camera) {
        case CameraFault::Frozen: {
            if (!frozen_) frozen_ = picture;
            Picture same = *frozen_;
            same.exposed_s = picture.exposed_s;
            return same;
        }
        case CameraFault::Black:
            return blackened(std::move(picture));
        case CameraFault::Corrupt:
            return corrupted(std::move(picture));
        case CameraFault::Huge:
            return claimingSize(std::move(picture), kHuge_px, kHuge_px);
        default:
            return picture;
    }
}

void CameraPublisher::send(const Picture& picture) {
    if (faults_.camera == CameraFault::Silent) return;
    std_msgs::Header header;
    header.stamp = clock_.at(picture.exposed_s);
    header.frame_id = kFrame;
    infoMessage_.header = header;
    info_.publish(infoMessage_);
    if (raw_.getNumSubscribers() > 0) sendRaw(picture, header);
    if (compressed_.getNumSubscribers() > 0) sendCompressed(picture, header);
}

void CameraPublisher::sendRaw(const Picture& picture, const std_msgs::Header& header) {
    sensor_msgs::Image message;
    message.header = header;
    message.width = static_cast<std::uint32_t>(picture.width_px);
    message.height = static_cast<std::uint32_t>(picture.height_px);
    message.encoding = sensor_msgs::image_encodings::RGB8;
    // A depth topic that was taken for the colour one.
    if (faults_.camera == CameraFault::WrongEncoding) message.encoding = sensor_msgs::image_encodings::TYPE_32FC1;
    message.step = 3 * message.width;
    message.data = picture.rgb;
    raw_.publish(message);
}

void CameraPublisher::sendCompressed(const Picture& picture, const std_msgs::Header& header) {
    sensor_msgs::CompressedImage message;
    message.header = header;
    message.format = "rgb8; jpeg compressed bgr8";
    message.data = picture.jpeg;
    if (faults_.camera == CameraFault::WrongEncoding) {
        message.format = "16UC1; compressedDepth png";
        message.data = compressedDepth(picture.width_px, picture.height_px);
    }
    compressed_.publish(message);
}

}  // namespace fodscope::robot_simulator
