// SPDX-License-Identifier: MIT
#include "storage/SessionFile.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include "core/common/Error.h"
#include "tests/fakes/SampleInspection.h"

namespace fodscope {
namespace {

using test::expectEqual;

TEST(SessionFile, AFullInspectionComesBackToTheLastBit) {
    const test::TemporaryFolder folder;
    InspectionState expected;
    std::string head;
    {
        const auto session = SessionFile::create(folder.file("a.fodscope"), test::sampleHeader());
        Inspection inspection(session->load(), *session);
        test::fillInspection(inspection);
        expected = inspection.state();
        expectEqual(session->load(), expected);
        head = session->headHash();
    }
    const auto session = SessionFile::open(folder.file("a.fodscope"));
    EXPECT_EQ(session->headHash(), head);
    expectEqual(session->load(), expected);
    const SessionVerification verification = session->verify();
    EXPECT_TRUE(verification.intact) << verification.problem;
    EXPECT_EQ(verification.headHash, head);
    EXPECT_EQ(verification.acts, 17u);
}

TEST(SessionFile, ANewOneHoldsItsHeaderAndNothingElse) {
    const test::TemporaryFolder folder;
    const auto session = SessionFile::create(folder.file("a.fodscope"), test::sampleHeader());
    InspectionState expected;
    expected.header = test::sampleHeader();
    expectEqual(session->load(), expected);
    EXPECT_TRUE(session->verify().intact);
}

TEST(SessionFile, ABadAlignmentIsKeptWithoutCandidates) {
    const test::TemporaryFolder folder;
    const auto session = SessionFile::create(folder.file("a.fodscope"), test::sampleHeader());
    Inspection inspection(session->load(), *session);
    DetectionResult bad;
    bad.registration.quality = RegistrationQuality::Bad;
    bad.registration.converged = false;
    inspection.adoptDetection(Parameters(), bad);
    expectEqual(session->load(), inspection.state());
    EXPECT_TRUE(session->verify().intact);
}

TEST(SessionFile, ThePosesOfAnAmbiguousAlignmentAreKept) {
    const test::TemporaryFolder folder;
    const auto session = SessionFile::create(folder.file("a.fodscope"), test::sampleHeader());
    Inspection inspection(session->load(), *session);
    DetectionResult ambiguous;
    ambiguous.registration = test::sampleDetection().registration;
    ambiguous.registration.quality = RegistrationQuality::Ambiguous;
    ambiguous.registration.alternatives.push_back({transformFromPose({4.0, 3.0, -2.4}), 0.009, 0.93, 0.86});
    ambiguous.registration.uncertainty->looseDirections.emplace_back(1.0, 0.0, 0.0);
    inspection.adoptDetection(Parameters(), ambiguous);
    expectEqual(session->load(), inspection.state());
    EXPECT_EQ(session->load().detection->registration.alternatives.size(), 1u);
}

TEST(SessionFile, WorkGoesOnAfterReopening) {
    const test::TemporaryFolder folder;
    {
        const auto session = SessionFile::create(folder.file("a.fodscope"), test::sampleHeader());
        Inspection inspection(session->load(), *session);
        test::fillInspection(inspection);
    }
    const auto session = SessionFile::open(folder.file("a.fodscope"));
    Inspection inspection(session->load(), *session);
    inspection.decide("P-002", "Ben", {{kNoFod, std::nullopt}}, "", {5});
    EXPECT_EQ(inspection.undoDecision("Anna", {6}), "P-001");
    EXPECT_THROW(inspection.adoptDetection(Parameters(), test::sampleDetection()), Error);
    expectEqual(session->load(), inspection.state());
    EXPECT_TRUE(session->verify().intact);
}

TEST(SessionFile, AnotherMapMakesTheDetectionVoidAlsoWhenReadBack) {
    const test::TemporaryFolder folder;
    const auto session = SessionFile::create(folder.file("a.fodscope"), test::sampleHeader());
    Inspection inspection(session->load(), *session);
    inspection.setMap({"map.pcd", std::string(64, 'b'), 10});
    inspection.adoptDetection(Parameters(), test::sampleDetection());
    inspection.setMap({"moved/map.pcd", std::string(64, 'b'), 10});
    EXPECT_TRUE(session->load().detection.has_value());
    inspection.setMap({"other.pcd", std::string(64, 'd'), 11});
    EXPECT_FALSE(inspection.state().detection.has_value());
    expectEqual(session->load(), inspection.state());
}

TEST(SessionFile, EqualCloudsAreKeptOnce) {
    const test::TemporaryFolder folder;
    const auto file = folder.file("a.fodscope");
    {
        const auto session = SessionFile::create(file, test::sampleHeader());
        Inspection inspection(session->load(), *session);
        Parameters parameters;
        for (int i = 0; i < 5; ++i) {
            parameters.candidates.threshold = 2.0 + i * 0.1;
            inspection.adoptDetection(parameters, test::sampleDetection());
        }
    }
    SQLite::Database database(file.string());
    EXPECT_EQ(database.execAndGet("SELECT count(*) FROM acts WHERE kind = 'detection'").getInt(), 5);
    EXPECT_EQ(database.execAndGet("SELECT count(*) FROM blobs WHERE format = 'fodscope.field/1'").getInt(), 1);
}

TEST(SessionFile, DetectionsOnTheSameCloudsAreKeptAsIfEachHadBroughtThemAlong) {
    const test::TemporaryFolder folder;
    const auto shared = SessionFile::create(folder.file("shared.fodscope"), test::sampleHeader());
    const auto copied = SessionFile::create(folder.file("copied.fodscope"), test::sampleHeader());
    Inspection sharing(shared->load(), *shared);
    Inspection copying(copied->load(), *copied);
    const DetectionResult detection = test::sampleDetection();
    DetectionResult tested = test::sampleDetection();
    auto field = std::make_shared<DiscrepancyField>(*tested.field);
    field->chiSquare.assign(field->size(), 5.0);
    tested.field = field;
    for (const DetectionResult* result :
         std::vector{&detection, &detection, &std::as_const(tested), &std::as_const(tested), &detection}) {
        sharing.adoptDetection(Parameters(), *result);
        DetectionResult copy = *result;
        copy.field = std::make_shared<DiscrepancyField>(*result->field);
        if (result->coverage) copy.coverage = std::make_shared<Coverage>(*result->coverage);
        copying.adoptDetection(Parameters(), copy);
        expectEqual(shared->load(), sharing.state());
        expectEqual(shared->load(), copied->load());
    }
    EXPECT_TRUE(shared->verify().intact);
}

TEST(SessionFile, TheChainKnowsItsHashes) {
    const test::TemporaryFolder folder;
    const auto session = SessionFile::create(folder.file("a.fodscope"), test::sampleHeader());
    const std::string first = session->headHash();
    session->recordMap({"map.pcd", std::string(64, 'b'), 10});
    EXPECT_NE(session->headHash(), first);
    EXPECT_TRUE(session->chainHolds(first));
    EXPECT_TRUE(session->chainHolds(session->headHash()));
    EXPECT_FALSE(session->chainHolds(std::string(64, '0')));
}

TEST(SessionFile, OthersCanQueryItWithPlainSql) {
    const test::TemporaryFolder folder;
    const auto file = folder.file("a.fodscope");
    {
        const auto session = SessionFile::create(file, test::sampleHeader());
        Inspection inspection(session->load(), *session);
        test::fillInspection(inspection);
    }
    SQLite::Database database(file.string());
    EXPECT_EQ(database.execAndGet("PRAGMA application_id").getInt64(), 0x464F4453);
    EXPECT_EQ(database.execAndGet("PRAGMA journal_mode").getString(), "wal");
    EXPECT_EQ(database.execAndGet("SELECT count(*) FROM candidates").getInt(), 2);
    EXPECT_EQ(database.execAndGet("SELECT status FROM waypoints WHERE x_map_m IS NULL").getString(), "hidden");
    EXPECT_EQ(database
                  .execAndGet("SELECT group_concat(label) FROM decision_labels JOIN decisions USING (act) "
                              "WHERE photo_id = 'P-001'")
                  .getString(),
              "hammer,drill");
    EXPECT_EQ(database.execAndGet("SELECT bytes FROM photos JOIN blobs USING (sha256) WHERE id = 'P-001'").getString(),
              "first photo");
    EXPECT_EQ(database.execAndGet("SELECT author FROM acts WHERE kind = 'decision' LIMIT 1").getString(), "Anna");
    EXPECT_EQ(database.execAndGet("SELECT author FROM acts WHERE kind = 'photo' LIMIT 1").getString(),
              "Ingrid Sørensen");
    EXPECT_THROW(database.exec("UPDATE acts SET author = 'Ben' WHERE sequence = 2"), SQLite::Exception);
    EXPECT_THROW(database.exec("DELETE FROM acts WHERE sequence = 2"), SQLite::Exception);
}

TEST(SessionFile, TextThatIsNoUtf8DoesNotLoseTheDecision) {
    const test::TemporaryFolder folder;
    const auto session = SessionFile::create(folder.file("a.fodscope"), test::sampleHeader());
    Inspection inspection(session->load(), *session);
    inspection.addPhoto(test::samplePhoto("W-01", "C-001", "photo"));
    inspection.setLabelSet(test::sampleLabels());
    inspection.decide("P-001", "Anna", {{"hammer", std::nullopt}}, "broken \xC3( text", {1});
    ASSERT_EQ(session->load().decisions.size(), 1u);
    EXPECT_TRUE(session->verify().intact);
}

}  // namespace
}  // namespace fodscope
