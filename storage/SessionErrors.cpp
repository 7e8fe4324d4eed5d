// SPDX-License-Identifier: MIT
#include "storage/SessionErrors.h"

#include <sqlite3.h>

namespace fodscope {

Error notASession(const std::filesystem::path& file) {
    return Error(file.string(), "is no session of Fodscope", "choose a .fodscope file");
}

Error damagedSession(const std::filesystem::path& file, const std::string& detail) {
    return Error(file.string(), "the session file is damaged (" + detail + ")", "restore it from a copy");
}

Error sessionError(const std::filesystem::path& file, const SQLite::Exception& exception) {
    const std::string name = file.string();
    // The low byte is the primary result code; SQLiteCpp reports −1 for its own errors.
    switch (exception.getErrorCode() & 0xFF) {
        case SQLITE_NOTADB:
            return notASession(file);
        case SQLITE_CORRUPT:
            return damagedSession(file, exception.what());
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return Error(name, "the session is open in another window or program", "close it there first");
        case SQLITE_READONLY:
            return Error(name, "the session file may not be written", "copy it to a folder of yours and open the copy");
        case SQLITE_FULL:
            return Error(name, "the act was not recorded because the disk is full", "make room and do it again");
        case SQLITE_IOERR:
            return Error(name, "the session file could not be read or written (" + std::string(exception.what()) + ")",
                         "check that the disk has room and is in order, then do it again");
        case SQLITE_CANTOPEN:
            return Error(name, "the session file cannot be opened",
                         "check that the file and its folder may be read and written");
        case SQLITE_TOOBIG:
            return Error(name, "a cloud or photo is larger than the session file can hold (1 GB)",
                         "use a coarser reference map");
        default:
            return Error(name, "the session file failed (" + std::string(exception.what()) + ")",
                         "copy the file to a safe place and check it with `fodscope-cli verify`");
    }
}

}  // namespace fodscope
