// SPDX-License-Identifier: MIT
#include "core/common/UtcTime.h"

#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>

namespace fodscope {

UtcTime UtcTime::now() {
    const auto sinceEpoch = std::chrono::system_clock::now().time_since_epoch();
    return {std::chrono::duration_cast<std::chrono::milliseconds>(sinceEpoch).count()};
}

std::string toIso8601(UtcTime time) {
    std::int64_t seconds = time.milliseconds / 1000;
    std::int64_t milliseconds = time.milliseconds % 1000;
    if (milliseconds < 0) {
        milliseconds += 1000;
        --seconds;
    }
    const std::time_t clock = static_cast<std::time_t>(seconds);
    std::tm parts{};
    gmtime_r(&clock, &parts);
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%04d-%02d-%02dT%02d:%02d:%02d.%03dZ", parts.tm_year + 1900,
                  parts.tm_mon + 1, parts.tm_mday, parts.tm_hour, parts.tm_min, parts.tm_sec,
                  static_cast<int>(milliseconds));
    return text.data();
}

}  // namespace fodscope
