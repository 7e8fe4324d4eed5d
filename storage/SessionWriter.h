// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include "storage/ActChain.h"
#include "storage/Payloads.h"

namespace fodscope {

/// Writes an act, the blobs that it names and the rows that follow from it. The caller holds the transaction.
/// @throws SQLite::Exception
void writeAct(SQLite::Database& database, const Act& act, const ActContent& content);

}  // namespace fodscope
