// SPDX-License-Identifier: MIT
#include "core/inspection/ReportText.h"

#include <array>
#include <charconv>
#include <cmath>

namespace fodscope {

std::string orNotRecorded(const std::string& text) {
    return text.empty() ? kNotRecorded : text;
}

std::string fixed(double value, int decimals) {
    if (!std::isfinite(value)) return kNotRecorded;
    std::array<char, 400> buffer{};
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
    std::string text(buffer.data(), end.ptr);
    const bool isMinusZero = text[0] == '-' && text.find_first_not_of("-0.") == std::string::npos;
    return isMinusZero ? text.substr(1) : text;
}

std::string percent(double share) {
    if (!std::isfinite(share)) return kNotRecorded;
    // 0.83 · 100 is a little less than 83.
    return fixed(std::floor(share * 100.0 + 1e-9), 0) + " %";
}

std::string length(double value_m) {
    if (!std::isfinite(value_m)) return kNotRecorded;
    const double size_m = std::abs(value_m);
    if (size_m < 0.0995) return fixed(value_m * 1000.0, 0) + " mm";
    if (size_m < 0.995) return fixed(value_m * 100.0, 0) + " cm";
    return fixed(value_m, 2) + " m";
}

std::string sizeText(const Eigen::Vector3d& size_m) {
    if (!size_m.allFinite()) return kNotRecorded;
    return fixed(size_m.x() * 100.0, 0) + " × " + fixed(size_m.y() * 100.0, 0) + " × " + fixed(size_m.z() * 100.0, 0) +
           " cm";
}

std::string placeText(const Eigen::Vector3d& point_m) {
    if (!point_m.allFinite()) return kNotRecorded;
    return "x " + fixed(point_m.x(), 2) + " m, y " + fixed(point_m.y(), 2) + " m, z " + fixed(point_m.z(), 2) + " m";
}

std::string discrepancyText(double value, Metric metric) {
    if (!std::isfinite(value)) return kNotRecorded;
    return metric == Metric::Euclidean ? length(value) : fixed(value, 2);
}

std::string timeText(UtcTime time) {
    if (time.milliseconds == 0) return kNotRecorded;
    std::string text = toIso8601(time).substr(0, 16);
    text[10] = ' ';
    return text + " UTC";
}

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : separator) + word;
    }
    return text;
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
    if (count == 0) return "no " + many;
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace fodscope
