// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace fodscope {

/// Milliseconds since 1970-01-01T00:00:00Z. Every act in the record carries one.
struct UtcTime {
    std::int64_t milliseconds = 0;

    static UtcTime now();
    auto operator<=>(const UtcTime&) const = default;
};

/// @return ISO 8601 with milliseconds, e.g. "2026-11-21T10:15:30.250Z"
std::string toIso8601(UtcTime time);

}  // namespace fodscope
