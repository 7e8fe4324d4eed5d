// SPDX-License-Identifier: MIT
#include "app/ros1_bridge/Picture.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <span>

#include "core/common/Error.h"
#include "core/robot/PhotoIntegrity.h"

namespace fodscope::bridge {
namespace {

constexpr double kGreatestPixelCount = 100e6;
constexpr std::size_t kGreatestFile = std::size_t{64} << 20;
/// Noise of a sensor in the dark stays below this.
constexpr double kBlackBelow = 10.0;

[[noreturn]] void refuse(const std::string& problem) {
    throw Error("camera image", problem, "check the camera");
}

struct Encoding {
    int type;
    /// To what PNG is written from; −1: as it is.
    int conversion;
};

Encoding encodingNamed(const std::string& name) {
    if (name == "rgb8") return {CV_8UC3, cv::COLOR_RGB2BGR};
    if (name == "bgr8" || name == "8UC3") return {CV_8UC3, -1};
    if (name == "rgba8") return {CV_8UC4, cv::COLOR_RGBA2BGR};
    if (name == "bgra8" || name == "8UC4") return {CV_8UC4, cv::COLOR_BGRA2BGR};
    if (name == "mono8" || name == "8UC1") return {CV_8UC1, -1};
    if (name == "yuv422") return {CV_8UC2, cv::COLOR_YUV2BGR_UYVY};
    if (name == "yuv422_yuy2") return {CV_8UC2, cv::COLOR_YUV2BGR_YUYV};
    refuse("its encoding '" + name + "' is none of a photo");
}

void requireLit(const cv::Mat& image) {
    double brightest = 0.0;
    cv::minMaxLoc(image.reshape(1), nullptr, &brightest);
    if (brightest < kBlackBelow) refuse("it is black; the light may be off or the lens covered");
}

Picture fromRaw(const ImageMessage& message) {
    const Encoding encoding = encodingNamed(message.encoding);
    const std::uint64_t row = std::uint64_t{message.width} * CV_ELEM_SIZE(encoding.type);
    if (message.width == 0 || message.height == 0) refuse("it has no pixels");
    if (static_cast<double>(message.width) * message.height > kGreatestPixelCount) refuse("it is huge");
    if (message.step < row || message.data.size < std::uint64_t{message.step} * (message.height - 1) + row)
        refuse("it is cut off");
    const cv::Mat borrowed(static_cast<int>(message.height), static_cast<int>(message.width), encoding.type,
                           const_cast<std::uint8_t*>(message.data.data), message.step);
    cv::Mat image = borrowed;
    if (encoding.conversion >= 0) cv::cvtColor(borrowed, image, encoding.conversion);
    requireLit(image);
    Picture picture{{}, image.cols, image.rows};
    // Fast rather than small: the robot stands and waits.
    cv::imencode(".png", image, picture.bytes, {cv::IMWRITE_PNG_COMPRESSION, 1});
    return picture;
}

Picture fromFile(const ImageMessage& message) {
    if (message.data.size > kGreatestFile) refuse("it is huge");
    const std::span bytes(message.data.data, message.data.size);
    const PhotoCheck check = checkPhoto(std::as_bytes(bytes));
    if (!check.problem.empty()) refuse(check.problem);
    const cv::Mat raw(1, static_cast<int>(bytes.size()), CV_8U, const_cast<std::uint8_t*>(bytes.data()));
    const cv::Mat image = cv::imdecode(raw, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
    requireLit(image);
    return {Bytes(bytes.begin(), bytes.end()), image.cols, image.rows};
}

}  // namespace

Picture pictureOf(const ImageMessage& message) {
    try {
        return message.isCompressed ? fromFile(message) : fromRaw(message);
    } catch (const cv::Exception&) {
        refuse("it cannot be read");
    }
}

}  // namespace fodscope::bridge
