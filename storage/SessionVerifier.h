// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include "storage/SessionFile.h"

namespace fodscope {

/// Recomputes everything that can be recomputed: the pages of the file, the chain of acts, the fingerprint of every
/// photo and cloud, and the tables that repeat what the acts say.
/// @throws SQLite::Exception
SessionVerification verifySession(SQLite::Database& database);

}  // namespace fodscope
