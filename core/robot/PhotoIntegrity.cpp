// SPDX-License-Identifier: MIT
#include "core/robot/PhotoIntegrity.h"

#include <algorithm>
#include <array>
#include <opencv2/imgcodecs.hpp>
#include <string_view>

namespace fodscope {
namespace {

using namespace std::string_view_literals;

constexpr double kGreatestPixelCount = 200e6;

std::string mediaTypeOf(std::string_view bytes) {
    if (bytes.starts_with("\xff\xd8\xff"sv)) return "image/jpeg";
    if (bytes.starts_with("\x89PNG\r\n\x1a\n"sv)) return "image/png";
    return "";
}

/// The end mark may be followed by a little padding, as some cameras write it.
bool hasEndMark(std::string_view bytes, const std::string& mediaType) {
    const auto lastUsed = bytes.find_last_not_of('\0');
    if (lastUsed == std::string_view::npos) return false;
    const std::string_view used = bytes.substr(0, lastUsed + 1);
    const std::string_view tail = used.substr(used.size() - std::min<std::size_t>(used.size(), 64));
    return tail.find(mediaType == "image/jpeg" ? "\xff\xd9"sv : "IEND"sv) != std::string_view::npos;
}

bool isAbsurdlyLargePng(std::string_view bytes) {
    if (bytes.size() < 24) return false;
    const auto bigEndian = [&](std::size_t at) {
        double value = 0.0;
        for (const char byte : bytes.substr(at, 4))
            value = value * 256.0 + static_cast<unsigned char>(byte);
        return value;
    };
    return bigEndian(16) * bigEndian(20) > kGreatestPixelCount;
}

/// @return the grey image; empty when it cannot be decoded
cv::Mat decoded(std::span<const std::byte> bytes) {
    try {
        const cv::Mat raw(1, static_cast<int>(bytes.size()), CV_8U, const_cast<std::byte*>(bytes.data()));
        return cv::imdecode(raw, cv::IMREAD_GRAYSCALE | cv::IMREAD_IGNORE_ORIENTATION);
    } catch (const cv::Exception&) {
        return {};
    }
}

/// Between the first and the last hundredth, so that single hot pixels and a printed time count for nothing.
double contrastOf(const cv::Mat& grey) {
    std::array<std::size_t, 256> counts{};
    for (int row = 0; row < grey.rows; ++row) {
        const auto* pixels = grey.ptr<unsigned char>(row);
        for (int column = 0; column < grey.cols; ++column)
            ++counts[pixels[column]];
    }
    const std::size_t hundredth = grey.total() / 100;
    const auto levelOf = [&](std::size_t rank) {
        std::size_t below = 0;
        int level = 0;
        while (level < 255 && (below += counts[static_cast<std::size_t>(level)]) <= rank)
            ++level;
        return level;
    };
    return levelOf(grey.total() - 1 - hundredth) - levelOf(hundredth);
}

}  // namespace

PhotoCheck checkPhoto(std::span<const std::byte> bytes) {
    if (bytes.empty()) return {"", "it has no bytes"};
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::string mediaType = mediaTypeOf(text);
    if (mediaType.empty()) return {"", "it is neither a JPEG nor a PNG image"};
    if (!hasEndMark(text, mediaType)) return {mediaType, "it is cut off"};
    if (mediaType == "image/png" && isAbsurdlyLargePng(text)) return {mediaType, "it has too many pixels"};
    const cv::Mat grey = decoded(bytes);
    if (grey.empty()) return {mediaType, "it cannot be decoded"};
    return {mediaType, "", contrastOf(grey)};
}

}  // namespace fodscope
