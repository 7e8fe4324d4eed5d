// SPDX-License-Identifier: MIT
#include "storage/SessionVerifier.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/common/Hash.h"
#include "storage/ActChain.h"
#include "storage/ActRows.h"
#include "storage/PayloadReading.h"
#include "storage/Payloads.h"
#include "storage/SessionReader.h"

namespace fodscope {
namespace {

using Json = nlohmann::ordered_json;

/// Ends a check at the first thing that was altered.
struct Altered {
    std::string problem;
};

std::string pageProblem(SQLite::Database& database) {
    const std::string answer = database.execAndGet("PRAGMA integrity_check(1)").getString();
    return answer == "ok" ? std::string() : "the file is damaged: " + answer;
}

std::string nameOfBlob(const Act& act, const Json& payload, const BlobName& blob) {
    if (act.kind == act_kind::kPhoto) return "the photo " + payload.at("id").get<std::string>();
    return "the " + blob.format + " cloud of " + nameOf(act);
}

/// Checks blobs by what the acts say of them; a blob that several acts name is read once.
class BlobCheck {
  public:
    explicit BlobCheck(SQLite::Database& database) : database_(database) {}

    void check(const std::string& name, const BlobName& expected) {
        if (!seen_.insert(expected.sha256).second) return;
        SQLite::Statement query(database_, "SELECT format, bytes FROM blobs WHERE sha256 = ?");
        query.bind(1, expected.sha256);
        if (!query.executeStep()) throw Altered{name + " is missing from the file"};
        const SQLite::Column bytes = query.getColumn(1);
        const auto* first = static_cast<const std::byte*>(bytes.getBlob());
        const std::span<const std::byte> content(first, static_cast<std::size_t>(bytes.getBytes()));
        if (content.size() != expected.bytes || sha256(content) != expected.sha256) {
            throw Altered{name + " was altered: its bytes do not have the fingerprint in the record"};
        }
        // Two acts may name the same bytes under different formats only if somebody made them do so.
        if (query.getColumn(0).getString() != expected.format) throw Altered{"the format of " + name + " was altered"};
    }

    void checkNothingElse() {
        SQLite::Statement query(database_, "SELECT sha256 FROM blobs ORDER BY rowid");
        while (query.executeStep()) {
            const std::string sha256 = query.getColumn(0).getString();
            if (!seen_.contains(sha256)) throw Altered{"a blob was added that no act names (" + sha256 + ")"};
        }
    }

  private:
    SQLite::Database& database_;
    std::set<std::string> seen_;
};

bool holds(const SQLite::Column& column, const CellValue& expected) {
    if (std::holds_alternative<std::monostate>(expected)) return column.isNull();
    if (const auto* whole = std::get_if<std::int64_t>(&expected)) {
        return column.isInteger() && column.getInt64() == *whole;
    }
    if (const auto* real = std::get_if<double>(&expected)) return column.isFloat() && column.getDouble() == *real;
    return column.isText() && column.getString() == std::get<std::string>(expected);
}

/// Compares the tables that repeat what the acts say with what they do say.
class RowCheck {
  public:
    explicit RowCheck(SQLite::Database& database) : database_(database) {}

    void check(const Act& act, const Json& payload) {
        std::map<std::string, int> positions;
        for (const ActRow& row : rowsOf(act.sequence, act.kind, payload)) {
            ++expectedRows_[row.table];
            checkRow(act, row, positions[row.table]++);
        }
    }

    void checkNothingElse() {
        for (const std::string& table : actRowTables()) {
            const auto rows = database_.execAndGet("SELECT count(*) FROM " + table).getInt64();
            if (rows != expectedRows_[table]) throw Altered{"a row was added to the table " + table};
        }
    }

  private:
    void checkRow(const Act& act, const ActRow& row, int position) {
        std::string columns;
        for (const auto& [name, value] : row.columns) {
            columns += (columns.empty() ? "" : ", ") + name;
        }
        const bool hasPosition =
            std::ranges::any_of(row.columns, [](const auto& column) { return column.first == "position"; });
        SQLite::Statement query(database_, "SELECT " + columns + " FROM " + row.table + " WHERE act = ?" +
                                               (hasPosition ? " AND position = ?" : ""));
        query.bind(1, act.sequence);
        if (hasPosition) query.bind(2, position);
        if (!query.executeStep()) throw Altered{"the table " + row.table + " lacks a row of " + nameOf(act)};
        for (std::size_t i = 0; i < row.columns.size(); ++i) {
            if (holds(query.getColumn(static_cast<int>(i)), row.columns[i].second)) continue;
            throw Altered{"the column " + row.columns[i].first + " of the table " + row.table +
                          " was altered: it differs from " + nameOf(act)};
        }
    }

    SQLite::Database& database_;
    std::map<std::string, std::int64_t> expectedRows_;
};

}  // namespace

SessionVerification verifySession(SQLite::Database& database) {
    SessionVerification result;
    result.problem = pageProblem(database);
    if (!result.problem.empty()) return result;
    BlobCheck blobs(database);
    RowCheck rows(database);
    std::string previousHash = firstPreviousHash();
    try {
        forEachAct(database, [&](const Act& act) {
            const std::string problem = chainProblem(act, static_cast<std::int64_t>(result.acts) + 1, previousHash);
            if (!problem.empty()) throw Altered{problem};
            const Json payload = Json::parse(act.payload);
            for (const BlobName& blob : blobsNamedIn(payload)) {
                blobs.check(nameOfBlob(act, payload, blob), blob);
            }
            rows.check(act, payload);
            previousHash = act.hash;
            ++result.acts;
        });
        blobs.checkNothingElse();
        rows.checkNothingElse();
    } catch (const Altered& altered) {
        result.problem = altered.problem;
    } catch (const nlohmann::json::exception& exception) {
        result.problem =
            "act " + std::to_string(result.acts + 1) + " does not hold what its kind says (" + exception.what() + ")";
    }
    result.headHash = previousHash;
    result.intact = result.problem.empty();
    return result;
}

}  // namespace fodscope
