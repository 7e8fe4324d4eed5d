// SPDX-License-Identifier: MIT
#include "app/robot_simulator/PictureFaults.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

namespace fodscope::robot_simulator {
namespace {

void putBigEndian16(std::vector<std::uint8_t>& bytes, std::size_t at, std::uint32_t value) {
    bytes[at] = static_cast<std::uint8_t>(value >> 8);
    bytes[at + 1] = static_cast<std::uint8_t>(value & 0xFF);
}

/// @return where the frame header (SOF0 to SOF2) begins, or the end
std::size_t frameHeader(const std::vector<std::uint8_t>& jpeg) {
    std::size_t at = 2;
    while (at + 9 < jpeg.size() && jpeg[at] == 0xFF) {
        if (jpeg[at + 1] >= 0xC0 && jpeg[at + 1] <= 0xC2) return at;
        at += 2 + (std::size_t{jpeg[at + 2]} << 8 | jpeg[at + 3]);
    }
    return jpeg.size();
}

}  // namespace

Picture blackened(Picture picture) {
    std::fill(picture.rgb.begin(), picture.rgb.end(), std::uint8_t{0});
    cv::imencode(".jpg", cv::Mat::zeros(picture.height_px, picture.width_px, CV_8UC3), picture.jpeg);
    return picture;
}

Picture corrupted(Picture picture) {
    picture.rgb.resize(picture.rgb.size() / 2);
    picture.jpeg.resize(picture.jpeg.size() / 3);
    for (std::size_t i = picture.jpeg.size() / 2; i < picture.jpeg.size(); i += 7)
        picture.jpeg[i] ^= 0x5A;
    return picture;
}

Picture claimingSize(Picture picture, std::uint32_t width_px, std::uint32_t height_px) {
    picture.width_px = static_cast<int>(width_px);
    picture.height_px = static_cast<int>(height_px);
    const std::size_t header = frameHeader(picture.jpeg);
    if (header + 9 > picture.jpeg.size()) return picture;
    putBigEndian16(picture.jpeg, header + 5, height_px);
    putBigEndian16(picture.jpeg, header + 7, width_px);
    return picture;
}

std::vector<std::uint8_t> compressedDepth(int width_px, int height_px) {
    std::vector<std::uint8_t> png;
    cv::imencode(".png", cv::Mat(height_px, width_px, CV_16UC1, cv::Scalar(1500)), png);
    png.insert(png.begin(), 12, std::uint8_t{0});
    return png;
}

}  // namespace fodscope::robot_simulator
