// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace fodscope {

/// "FODS": marks an SQLite file as a session of Fodscope.
inline constexpr std::int64_t kSessionApplicationId = 0x464F4453;

/// The format that this version writes, and the newest that it reads.
inline constexpr std::int64_t kSessionVersion = 2;

/// What a file of the first version lacks.
inline constexpr const char* kFromVersion1 =
    "ALTER TABLE visits ADD COLUMN detail TEXT NOT NULL DEFAULT '';"
    "ALTER TABLE visits ADD COLUMN photo_tries INTEGER NOT NULL DEFAULT 0;"
    "ALTER TABLE photos ADD COLUMN request_id TEXT NOT NULL DEFAULT '';"
    "PRAGMA user_version = 2";

/// The text of schema.sql.
extern const char* const kSessionSchema;

}  // namespace fodscope
