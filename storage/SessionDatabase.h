// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>
#include <functional>
#include <memory>

namespace fodscope {

/// A new file under that name, which must be free, with the schema and what `fill` writes, all in one transaction.
/// @throws Error when the name is taken or the file cannot be made; no file is then left behind
std::unique_ptr<SQLite::Database> createSessionDatabase(const std::filesystem::path& file,
                                                        const std::function<void(SQLite::Database&)>& fill);

/// A session that is held for this program alone until it is closed, checked to be one and to be whole.
/// @throws Error when it is missing, no session, truncated, damaged, of a newer version, in use, or may not be written
std::unique_ptr<SQLite::Database> openSessionDatabase(const std::filesystem::path& file);

/// The same for a file that may not be written, such as one on a read-only medium. Nothing is locked or written.
std::unique_ptr<SQLite::Database> openSessionDatabaseForReading(const std::filesystem::path& file);

}  // namespace fodscope
