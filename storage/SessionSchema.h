// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace fodscope {

/// "FODS": marks an SQLite file as a session of Fodscope.
inline constexpr std::int64_t kSessionApplicationId = 0x464F4453;

/// The format that this version writes, and the newest that it reads.
inline constexpr std::int64_t kSessionVersion = 1;

/// The text of schema.sql.
extern const char* const kSessionSchema;

}  // namespace fodscope
