// SPDX-License-Identifier: MIT
#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include "storage/ActChain.h"
#include "storage/SessionFile.h"
#include "tests/fakes/SampleInspection.h"

namespace fodscope {
namespace {

/// One way to alter a session, and words of the sentence that must name it.
struct Tampering {
    const char* name;
    const char* sql;
    const char* words;
};

class Tamper : public testing::TestWithParam<Tampering> {};

/// Somebody who alters the file also removes what stands in the way.
void alter(const std::filesystem::path& file, const std::string& sql) {
    SQLite::Database database(file.string(), SQLite::OPEN_READWRITE);
    database.exec(
        "PRAGMA foreign_keys = OFF; DROP TRIGGER acts_are_never_changed; DROP TRIGGER acts_are_never_deleted");
    database.exec(sql);
}

void makeSession(const std::filesystem::path& file) {
    const auto session = SessionFile::create(file, test::sampleHeader());
    Inspection inspection(session->load(), *session);
    test::fillInspection(inspection);
}

TEST_P(Tamper, IsFoundAndNamed) {
    const test::TemporaryFolder folder;
    const auto file = folder.file("a.fodscope");
    makeSession(file);
    alter(file, GetParam().sql);
    const SessionVerification verification = SessionFile::open(file)->verify();
    EXPECT_FALSE(verification.intact);
    EXPECT_NE(verification.problem.find(GetParam().words), std::string::npos) << verification.problem;
}

INSTANTIATE_TEST_SUITE_P(
    Every, Tamper,
    testing::Values(
        Tampering{"Payload", "UPDATE acts SET payload = replace(payload, 'hammer', 'wrench') WHERE kind = 'decision'",
                  "(decision by Anna"},
        Tampering{"Author", "UPDATE acts SET author = 'Ben' WHERE sequence = 15", "act 15 (decision by Ben"},
        Tampering{"Time", "UPDATE acts SET time_utc = '2020-01-01T00:00:00.000Z' WHERE sequence = 4", "act 4"},
        Tampering{"Version", "UPDATE acts SET software_version = '9' WHERE sequence = 4", "act 4"},
        Tampering{"Hash",
                  "UPDATE acts SET hash = 'f' || substr(hash, 2) WHERE sequence = 4 AND hash NOT LIKE 'f%';"
                  "UPDATE acts SET hash = '0' || substr(hash, 2) WHERE sequence = 4 AND hash LIKE 'f%'",
                  "act 4"},
        Tampering{"PreviousHash", "UPDATE acts SET previous_hash = hash WHERE sequence = 4", "act 4"},
        Tampering{"ActRemoved", "DELETE FROM acts WHERE sequence = 3", "act 3 is missing"},
        Tampering{"FirstActRemoved", "DELETE FROM acts WHERE sequence = 1", "act 1 is missing"},
        Tampering{"ActsSwapped",
                  "UPDATE acts SET sequence = 100 WHERE sequence = 8; UPDATE acts SET sequence = 8 WHERE sequence = 9;"
                  "UPDATE acts SET sequence = 9 WHERE sequence = 100",
                  "act 8"},
        Tampering{"LastActsRowsLeft", "DELETE FROM acts WHERE kind IN ('report', 'decision')",
                  "a row was added to the table decisions"},
        Tampering{"PhotoBytes",
                  "UPDATE blobs SET bytes = CAST('other photo' AS BLOB) WHERE bytes = CAST('first photo' AS BLOB)",
                  "the photo P-001 was altered"},
        Tampering{"PhotoRemoved", "DELETE FROM blobs WHERE bytes = CAST('first photo' AS BLOB)",
                  "the photo P-001 is missing"},
        Tampering{"PhotoFormat", "UPDATE blobs SET format = 'image/png' WHERE bytes = CAST('first photo' AS BLOB)",
                  "the photo P-001"},
        Tampering{"ReferenceCloud",
                  "UPDATE blobs SET bytes = zeroblob(length(bytes)) WHERE format = 'fodscope.reference/1'",
                  "fodscope.reference/1 cloud of act 3"},
        Tampering{"Field", "UPDATE blobs SET bytes = zeroblob(length(bytes)) WHERE format = 'fodscope.field/1'",
                  "fodscope.field/1 cloud"},
        Tampering{"Voxels", "UPDATE blobs SET bytes = zeroblob(9) WHERE format = 'fodscope.voxels/1'",
                  "fodscope.voxels/1 cloud"},
        Tampering{"Coverage", "DELETE FROM blobs WHERE format = 'fodscope.coverage/1'", "fodscope.coverage/1 cloud"},
        Tampering{"Grid", "UPDATE blobs SET bytes = zeroblob(1) WHERE format = 'fodscope.grid/1'",
                  "fodscope.grid/1 cloud"},
        Tampering{"BlobAdded", "INSERT INTO blobs VALUES ('x', 'image/png', zeroblob(3))", "a blob was added"},
        Tampering{"CandidateRow", "UPDATE candidates SET centroid_x_map_m = 1.5 WHERE id = 'C-001'",
                  "centroid_x_map_m of the table candidates"},
        Tampering{"CandidateRowRemoved", "DELETE FROM candidates WHERE id = 'C-002'", "the table candidates lacks"},
        Tampering{"WaypointRow", "UPDATE waypoints SET status = 'ok'", "status of the table waypoints"},
        Tampering{"VisitRow", "UPDATE visits SET state = 'done' WHERE state = 'skipped'", "state of the table visits"},
        Tampering{"PhotoRow", "UPDATE photos SET taken_utc = '2020' WHERE id = 'P-001'",
                  "taken_utc of the table photos"},
        Tampering{"DecisionRow", "UPDATE decisions SET labeller = 'Ben'", "labeller of the table decisions"},
        Tampering{"DecisionRowAdded", "INSERT INTO decisions VALUES (99, 'P-001', 'Ben', '2026', 0, '')",
                  "a row was added to the table decisions"},
        Tampering{"LabelRow", "UPDATE decision_labels SET label = 'no FOD' WHERE label = 'hammer'",
                  "label of the table decision_labels"},
        Tampering{"BoxRow", "UPDATE decision_labels SET left_px = NULL", "left_px of the table decision_labels"}),
    [](const auto& info) { return info.param.name; });

TEST(SessionVerify, ARewrittenChainIsFoundByItsEarlierHead) {
    const test::TemporaryFolder folder;
    const auto file = folder.file("a.fodscope");
    makeSession(file);
    const std::string head = SessionFile::open(file)->headHash();
    // The last act is replaced by another one with a right hash: the chain alone cannot tell.
    {
        SQLite::Database database(file.string(), SQLite::OPEN_READWRITE);
        database.exec("DROP TRIGGER acts_are_never_changed");
        SQLite::Statement query(database,
                                "SELECT sequence, kind, payload, author, time_utc, software_version, previous_hash "
                                "FROM acts ORDER BY sequence DESC LIMIT 1");
        ASSERT_TRUE(query.executeStep());
        const auto text = [&](int column) { return query.getColumn(column).getString(); };
        Act act{query.getColumn(0).getInt64(), text(1), text(2), "Ben", text(4), text(5), text(6), ""};
        act.hash = hashOf(act);
        SQLite::Statement update(database, "UPDATE acts SET author = ?, hash = ? WHERE sequence = ?");
        update.bind(1, act.author);
        update.bind(2, act.hash);
        update.bind(3, act.sequence);
        update.exec();
    }
    const auto session = SessionFile::open(file);
    EXPECT_TRUE(session->verify().intact);
    EXPECT_FALSE(session->chainHolds(head));
}

}  // namespace
}  // namespace fodscope
