// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>

#include "core/common/Error.h"
#include "tests/fakes/SampleInspection.h"
#include "ui/session/CandidatePreview.h"
#include "ui/session/MapLoading.h"
#include "ui/session/RecentSessions.h"
#include "ui/session/ReferenceSources.h"
#include "ui/session/Steps.h"
#include "ui/session/UndoHistory.h"

namespace fodscope::test {
namespace {

TEST(ReferenceRequest, MeshWithMapsGivesTheMeshCovariances) {
    QTemporaryDir folder;
    const std::string mesh = folder.filePath("tank.stl").toStdString();
    const std::string map = folder.filePath("map.pcd").toStdString();
    std::ofstream(mesh) << "solid tank\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                           "endloop\nendfacet\nendsolid tank\n";
    const ReferenceRequest both = requestFor({map, mesh});
    EXPECT_EQ(both.kind, ReferenceKind::CadAndMaps);
    EXPECT_EQ(both.files, std::vector<std::filesystem::path>{mesh});
    EXPECT_EQ(both.covarianceMaps, std::vector<std::filesystem::path>{map});
    EXPECT_EQ(requestFor({mesh}).kind, ReferenceKind::Cad);
    EXPECT_EQ(requestFor({map}).kind, ReferenceKind::Ready);
    EXPECT_EQ(requestFor({map, map}).kind, ReferenceKind::NominalMaps);
}

TEST(UndoHistory, GoesBackAndForthInOrder) {
    UndoHistory history;
    std::string done;
    for (const char letter : {'a', 'b'})
        history.add({QString(QLatin1Char(letter)), [&done] { done.pop_back(); }, [&done, letter] { done += letter; }});
    done = "ab";
    history.undo();
    EXPECT_EQ(done, "a");
    EXPECT_EQ(history.redoName(), "b");
    history.undo();
    history.redo();
    EXPECT_EQ(done, "a");
    history.add({"c", [&done] { done.pop_back(); }, [&done] { done += 'c'; }});
    EXPECT_FALSE(history.canRedo());
}

TEST(UndoHistory, ActThatCannotBeTakenBackStaysDone) {
    UndoHistory history;
    history.add({"write", [] { throw Error("disk", "it is full", "free some space"); }, [] {}});
    EXPECT_THROW(history.undo(), Error);
    EXPECT_TRUE(history.canUndo());
}

TEST(Steps, EmptyInspectionBeginsWithTheReference) {
    InspectionState state;
    for (const StepState step : stepStates(state))
        EXPECT_EQ(step, StepState::ToDo);
    EXPECT_EQ(firstOpenStep(state), Step::Reference);
}

TEST(Steps, BadAlignmentNeedsALookAndHasNoCandidates) {
    InspectionState state;
    state.reference = std::make_shared<const ReferenceMap>(sampleReference());
    state.mapSource = SourceFile{"map.pcd", "", 10};
    state.detection = DetectionRecord{};
    state.detection->registration.quality = RegistrationQuality::Bad;
    const auto steps = stepStates(state);
    EXPECT_EQ(steps[static_cast<std::size_t>(Step::Reference)], StepState::Done);
    EXPECT_EQ(steps[static_cast<std::size_t>(Step::Map)], StepState::NeedsLook);
    EXPECT_EQ(steps[static_cast<std::size_t>(Step::Candidates)], StepState::ToDo);
}

TEST(Steps, LabelIsDoneWhenEveryPhotoHasADecisionThatCounts) {
    InspectionState state;
    state.photos.push_back(samplePhoto("W-01", "C-001", "one"));
    state.photos.back().id = "P-001";
    const auto label = static_cast<std::size_t>(Step::Label);
    EXPECT_EQ(stepStates(state)[label], StepState::NeedsLook);
    Decision decision{"P-001", "Anna", UtcTime{1}, {{kNoFod, std::nullopt}}, ""};
    state.decisions.push_back(decision);
    EXPECT_EQ(stepStates(state)[label], StepState::Done);
    decision.labels.clear();
    decision.time = UtcTime{2};
    state.decisions.push_back(decision);
    EXPECT_EQ(stepStates(state)[label], StepState::NeedsLook);
}

TEST(RecentSessions, KeepsNewestFirstAndForgetsWhatIsGone) {
    QSettings().clear();
    const QTemporaryDir folder;
    for (const char* name : {"a.fodscope", "b.fodscope"}) {
        QFile file(folder.filePath(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        RecentSessions().add(file.fileName());
    }
    EXPECT_EQ(RecentSessions().files(), QStringList({folder.filePath("b.fodscope"), folder.filePath("a.fodscope")}));
    QFile::remove(folder.filePath("b.fodscope"));
    EXPECT_EQ(RecentSessions().files(), QStringList({folder.filePath("a.fodscope")}));
}

TEST(RecentSessions, RemembersTheStepOfEachInspection) {
    QSettings().clear();
    EXPECT_FALSE(RecentSessions().stepOf("one"));
    RecentSessions().rememberStep("one", Step::Label);
    EXPECT_EQ(RecentSessions().stepOf("one"), Step::Label);
    EXPECT_FALSE(RecentSessions().stepOf("two"));
}

TEST(CandidatePreview, LastRequestWins) {
    CandidatePreview preview(std::make_shared<CandidateFinder>());
    QSignalSpy ready(&preview, &CandidatePreview::ready);
    double shown = -1.0;
    QObject::connect(&preview, &CandidatePreview::ready, &preview,
                     [&](const auto&, const CandidateSettings& settings) { shown = settings.threshold; });
    PreviewRequest request;
    request.detection.field = sampleDetection().field;
    request.settings.metric = Metric::Euclidean;
    for (int i = 0; i < 20; ++i) {
        request.settings.threshold = 0.001 * i;
        preview.request(request);
    }
    ASSERT_TRUE(QTest::qWaitFor([&] { return !preview.isBusy(); }));
    EXPECT_DOUBLE_EQ(shown, 0.019);
    EXPECT_LT(ready.count(), 20);
}

TEST(CandidatePreview, DroppedPreviewNeverShows) {
    CandidatePreview preview(std::make_shared<CandidateFinder>());
    QSignalSpy ready(&preview, &CandidatePreview::ready);
    PreviewRequest request;
    request.detection.field = sampleDetection().field;
    request.settings.metric = Metric::Euclidean;
    preview.request(request);
    preview.drop();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !preview.isBusy(); }));
    EXPECT_EQ(ready.count(), 0);
}

TEST(TransformCsv, TakesFourRowsOfFourAndNothingElse) {
    const TemporaryFolder folder;
    const auto write = [&](const char* text) {
        std::ofstream(folder.file("T.csv")) << text;
        return folder.file("T.csv");
    };
    EXPECT_DOUBLE_EQ(readTransformCsv(write("1,0,0,2\n0,1,0,3\n0,0,1,4\n0,0,0,1\n")).translation().z(), 4.0);
    EXPECT_THROW(readTransformCsv(write("1,0,0,2\n0,1,0,3\n")), Error);
    EXPECT_THROW(readTransformCsv(write("1,0,0,2\n0,1,0,3\n0,0,1,4\n0,0,0,1\n5\n")), Error);
    EXPECT_THROW(readTransformCsv(write("2,0,0,2\n0,2,0,3\n0,0,2,4\n0,0,0,1\n")), Error);
}

}  // namespace
}  // namespace fodscope::test
