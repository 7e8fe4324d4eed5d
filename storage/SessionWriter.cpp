// SPDX-License-Identifier: MIT
#include "storage/SessionWriter.h"

#include <nlohmann/json.hpp>

#include "core/common/Hash.h"
#include "storage/ActRows.h"

namespace fodscope {
namespace {

void insertAct(SQLite::Database& database, const Act& act) {
    SQLite::Statement insert(database, "INSERT INTO acts VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
    insert.bind(1, act.sequence);
    int column = 2;
    for (const std::string* text :
         {&act.kind, &act.payload, &act.author, &act.timeUtc, &act.softwareVersion, &act.previousHash, &act.hash}) {
        insert.bindNoCopy(column++, *text);
    }
    insert.exec();
}

/// Equal bytes are kept once: while tuning, many detections rest on the same cloud.
void insertBlob(SQLite::Database& database, const Blob& blob) {
    SQLite::Statement insert(database, "INSERT INTO blobs VALUES (?, ?, ?) ON CONFLICT (sha256) DO NOTHING");
    insert.bind(1, sha256(blob.bytes));
    insert.bind(2, blob.format);
    insert.bindNoCopy(3, blob.bytes.data(), static_cast<int>(blob.bytes.size()));
    insert.exec();
}

void insertRow(SQLite::Database& database, const ActRow& row) {
    std::string names;
    std::string marks;
    for (const auto& [name, value] : row.columns) {
        names += (names.empty() ? "" : ", ") + name;
        marks += marks.empty() ? "?" : ", ?";
    }
    SQLite::Statement insert(database, "INSERT INTO " + row.table + " (" + names + ") VALUES (" + marks + ")");
    int column = 1;
    for (const auto& [name, value] : row.columns) {
        if (const auto* whole = std::get_if<std::int64_t>(&value)) insert.bind(column, *whole);
        if (const auto* real = std::get_if<double>(&value)) insert.bind(column, *real);
        if (const auto* text = std::get_if<std::string>(&value)) insert.bind(column, *text);
        ++column;
    }
    insert.exec();
}

}  // namespace

void writeAct(SQLite::Database& database, const Act& act, const ActContent& content) {
    insertAct(database, act);
    for (const Blob& blob : content.blobs) {
        insertBlob(database, blob);
    }
    const auto payload = nlohmann::ordered_json::parse(act.payload);
    for (const ActRow& row : rowsOf(act.sequence, act.kind, payload)) {
        insertRow(database, row);
    }
}

}  // namespace fodscope
