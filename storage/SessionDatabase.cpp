// SPDX-License-Identifier: MIT
#include "storage/SessionDatabase.h"

#include <fcntl.h>
#include <sqlite3.h>
#include <unistd.h>

#include <array>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <string_view>
#include <system_error>

#include "core/common/Error.h"
#include "storage/SessionErrors.h"
#include "storage/SessionSchema.h"

namespace fodscope {
namespace {

constexpr std::string_view kSqliteMagic("SQLite format 3\0", 16);

std::filesystem::path walOf(const std::filesystem::path& file) {
    return file.string() + "-wal";
}

bool hasWal(const std::filesystem::path& file) {
    std::error_code code;
    const auto size = std::filesystem::file_size(walOf(file), code);
    return !code && size > 0;
}

/// What can be told before SQLite sees the file, so that the sentence is exact.
void checkHeader(const std::filesystem::path& file) {
    std::error_code code;
    const auto status = std::filesystem::status(file, code);
    if (!std::filesystem::exists(status)) throw Error(file.string(), "no such session file", "check the name");
    if (!std::filesystem::is_regular_file(status)) throw Error(file.string(), "is no file", "choose a .fodscope file");
    const auto size = std::filesystem::file_size(file, code);
    if (size == 0 && !hasWal(file)) {
        throw Error(file.string(), "the session file is empty", "delete it and start a new inspection");
    }
    std::ifstream stream(file, std::ios::binary);
    std::array<char, 100> header{};
    stream.read(header.data(), header.size());
    if (!stream && !stream.eof()) throw Error(file.string(), "cannot be read", "check that it may be read");
    const std::string_view text(header.data(), static_cast<std::size_t>(stream.gcount()));
    if (text.empty() && hasWal(file)) return;
    if (!text.starts_with(kSqliteMagic)) throw notASession(file);
    const auto byte = [&](std::size_t i) { return static_cast<std::uint64_t>(static_cast<unsigned char>(header[i])); };
    const std::uint64_t pageSize = (byte(16) << 8 | byte(17)) == 1 ? 65536 : byte(16) << 8 | byte(17);
    const std::uint64_t pages = byte(28) << 24 | byte(29) << 16 | byte(30) << 8 | byte(31);
    if (text.size() < header.size() || (!hasWal(file) && size < pages * pageSize)) {
        throw Error(file.string(), "the session file is truncated", "copy it anew or restore it from a backup");
    }
}

std::int64_t number(SQLite::Database& database, const char* sql) {
    return database.execAndGet(sql).getInt64();
}

void checkVersion(SQLite::Database& database, const std::filesystem::path& file) {
    if (number(database, "PRAGMA application_id") != kSessionApplicationId) throw notASession(file);
    const std::int64_t version = number(database, "PRAGMA user_version");
    if (version > kSessionVersion) {
        throw Error(file.string(),
                    "the session was made by a newer Fodscope (session format " + std::to_string(version) +
                        ", this one reads up to " + std::to_string(kSessionVersion) + ")",
                    "open it with the newer version");
    }
    if (version < 1) throw damagedSession(file, "it has no format number");
}

void checkPages(SQLite::Database& database, const std::filesystem::path& file) {
    const std::string answer = database.execAndGet("PRAGMA quick_check(1)").getString();
    if (answer != "ok") throw damagedSession(file, answer);
}

/// Before the first access: no other program gets in until the file is closed, and no shared memory file is needed.
void configure(SQLite::Database& database) {
    database.exec("PRAGMA locking_mode = EXCLUSIVE");
    database.exec("PRAGMA trusted_schema = OFF");
    database.exec("PRAGMA foreign_keys = ON");
}

void makeDurable(SQLite::Database& database) {
    database.exec("PRAGMA journal_mode = WAL");
    database.exec("PRAGMA synchronous = FULL");
}

/// Makes the file only if nothing has that name, which SQLite alone would not tell.
void claim(const std::filesystem::path& file) {
    const int descriptor = ::open(file.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0644);
    if (descriptor >= 0) {
        ::close(descriptor);
        return;
    }
    const int errorNumber = errno;
    if (errorNumber == EEXIST) {
        throw Error(file.string(), "a file of that name exists", "choose another name or open that session");
    }
    throw Error(file.string(), "the session file cannot be made (" + std::generic_category().message(errorNumber) + ")",
                "choose a folder that exists and may be written");
}

void removeAll(const std::filesystem::path& file) {
    std::error_code ignored;
    for (const char* suffix : {"", "-wal", "-shm", "-journal"}) {
        std::filesystem::remove(file.string() + suffix, ignored);
    }
}

}  // namespace

std::unique_ptr<SQLite::Database> createSessionDatabase(const std::filesystem::path& file,
                                                        const std::function<void(SQLite::Database&)>& fill) {
    claim(file);
    try {
        auto database = std::make_unique<SQLite::Database>(file.string(), SQLite::OPEN_READWRITE);
        configure(*database);
        makeDurable(*database);
        SQLite::Transaction transaction(*database, SQLite::TransactionBehavior::IMMEDIATE);
        database->exec(kSessionSchema);
        fill(*database);
        transaction.commit();
        return database;
    } catch (const SQLite::Exception& exception) {
        removeAll(file);
        throw sessionError(file, exception);
    }
}

std::unique_ptr<SQLite::Database> openSessionDatabase(const std::filesystem::path& file) {
    checkHeader(file);
    if (::access(file.c_str(), W_OK) != 0) {
        throw Error(file.string(), "the session file may not be written",
                    "copy it to a folder of yours and open the copy");
    }
    try {
        auto database = std::make_unique<SQLite::Database>(file.string(), SQLite::OPEN_READWRITE);
        configure(*database);
        checkVersion(*database, file);
        checkPages(*database, file);
        makeDurable(*database);
        SQLite::Transaction lock(*database, SQLite::TransactionBehavior::IMMEDIATE);
        if (number(*database, "PRAGMA user_version") == 1) database->exec(kFromVersion1);
        lock.commit();
        return database;
    } catch (const SQLite::Exception& exception) {
        throw sessionError(file, exception);
    }
}

std::unique_ptr<SQLite::Database> openSessionDatabaseForReading(const std::filesystem::path& file) {
    checkHeader(file);
    if (hasWal(file)) {
        throw Error(file.string(), "the session was not closed properly and its last acts cannot be read in this place",
                    "copy it with its -wal file to a folder that may be written");
    }
    std::string uri = "file:";
    for (const unsigned char c : std::filesystem::absolute(file).string()) {
        constexpr const char* kDigits = "0123456789ABCDEF";
        const bool plain = std::isalnum(c) != 0 || c == '/' || c == '.' || c == '-' || c == '_';
        uri += plain ? std::string(1, static_cast<char>(c)) : std::string{'%', kDigits[c >> 4], kDigits[c & 15]};
    }
    try {
        auto database =
            std::make_unique<SQLite::Database>(uri + "?immutable=1", SQLite::OPEN_READONLY | SQLite::OPEN_URI);
        checkVersion(*database, file);
        checkPages(*database, file);
        return database;
    } catch (const SQLite::Exception& exception) {
        throw sessionError(file, exception);
    }
}

}  // namespace fodscope
