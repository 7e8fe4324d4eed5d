// SPDX-License-Identifier: MIT
#include "ui/tuning/TuningDialog.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include "tests/ui/Screenshot.h"
#include "ui/session/FileDialogs.h"
#include "ui/session/InspectionController.h"
#include "ui/tuning/CostSurface.h"
#include "ui/tuning/RecallPlot.h"

namespace fodscope::test {
namespace {

class OneFolder : public FileDialogs {
  public:
    QString next;
    QString openFile(QWidget*, const QString&, const QString&) override { return next; }
    QStringList openFiles(QWidget*, const QString&, const QString&) override { return {next}; }
    QString saveFile(QWidget*, const QString&, const QString&, const QString&) override { return next; }
    QString chooseFolder(QWidget*, const QString&, const QString&) override { return next; }
};

/// A lump of four voxels on a FOD, and a pair of voxels that is none: Euclidean discrepancy 40 and 20 mm.
MeasuredTrials sampleTrials() {
    auto field = std::make_shared<DiscrepancyField>();
    const auto add = [&](double x, double y, double discrepancy_m) {
        field->points.emplace_back(x, y, 0.0);
        field->weights.push_back(1);
        field->nearest.push_back(0);
        field->euclidean_m.push_back(discrepancy_m);
        field->smoothedEuclidean_m.push_back(discrepancy_m);
    };
    for (const double x : {0.0, 0.02})
        for (const double y : {0.0, 0.02})
            add(x, y, 0.04);
    add(2.0, 0.0, 0.02);
    add(2.02, 0.0, 0.02);
    for (int i = 0; i < 20; ++i)
        add(3.0 + i, 5.0, 0.001);
    SearchTrial trial;
    trial.name = "trial";
    trial.field = field;
    trial.fods_map = {{0.01, 0.01, 0.0}};
    MeasuredTrials measured;
    measured.trials = {trial};
    return measured;
}

TuningOutcome sampleOutcome() {
    Progress progress;
    TuningOutcome outcome;
    outcome.measured = std::make_shared<const MeasuredTrials>(sampleTrials());
    ParameterSearchSettings search;
    search.metric = Metric::Euclidean;
    outcome.result = searchParameters(outcome.measured->trials, search, progress);
    outcome.inEffect.metric = Metric::Euclidean;
    outcome.inEffect.threshold = 0.01;
    outcome.inEffect.clusterCutoff_m = 0.3;
    outcome.costInEffect = costOf(outcome.measured->trials, outcome.inEffect, search.lambda_m, progress);
    return outcome;
}

/// Ten FOD. The lower threshold shows nine of them on 20 photos, the upper one six on 8; the cutoffs make no
/// difference. In effect is a setting between, with 15 photos of which 9 show FOD.
PhotoTuningOutcome samplePhotos() {
    PhotoTuningOutcome tuning;
    PhotoSearchResult& result = tuning.result;
    result.settings.recall = 0.8;
    result.settings.grid.metric = Metric::Euclidean;
    result.trialCount = 3;
    result.fodCount = 10;
    result.cutoffs_m = {0.2, 0.4};
    result.thresholds = {0.02, 0.04};
    result.leastPoints = {3};
    const PhotoOutcome many{20, 12, 9, 22, 2};
    const PhotoOutcome few{8, 8, 6, 9, 1};
    result.outcomes = {many, few, many, few};
    result.curve = {{{0, 1, 0}, few}, {{0, 0, 0}, many}};
    result.best = result.curve[1];
    tuning.inEffect = result.settingsAt({0, 0, 0});
    tuning.inEffect.threshold = 0.03;
    tuning.outcomeInEffect = PhotoOutcome{15, 9, 7, 15, 0};
    return tuning;
}

class Tuning : public ::testing::Test {
  protected:
    Tuning() {
        controller.createSession(folder.filePath("inspection.fodscope"), newInspectionHeader());
        dialog = std::make_unique<TuningDialog>(controller, files);
        dialog->show();
    }

    template <typename W>
    W* find(const char* name) {
        W* widget = dialog->findChild<W*>(QString::fromLatin1(name));
        EXPECT_NE(widget, nullptr) << name;
        return widget;
    }

    QTemporaryDir folder;
    OneFolder files;
    InspectionController controller;
    std::unique_ptr<TuningDialog> dialog;
};

TEST(TuningSearch, CostOfSettingsIsDistancePlusWhatIsSuperfluous) {
    const TuningOutcome outcome = sampleOutcome();
    EXPECT_DOUBLE_EQ(outcome.costInEffect.unassociatedCandidates, 1.0);
    EXPECT_NEAR(outcome.costInEffect.cost, 0.05, 1e-12);
    EXPECT_NEAR(outcome.result.at(outcome.result.best).cost, 0.0, 1e-12);
}

TEST(TuningSearch, GridOfOneCountHoldsItsCosts) {
    const TuningOutcome outcome = sampleOutcome();
    const CostGrid grid = costGridOf(outcome.result, 2);
    ASSERT_EQ(grid.cost_m.size(), 30u * 20u);
    EXPECT_EQ(grid.at(7, 3), outcome.result.at({7, 3, 2}).cost);
    const CandidateSettings settings = settingsAt(outcome.result, {7, 3, 2});
    EXPECT_EQ(settings.clusterCutoff_m, outcome.result.cutoffs_m[7]);
    EXPECT_EQ(settings.threshold, outcome.result.thresholds[3]);
    EXPECT_EQ(settings.minimumPoints, 2);
    EXPECT_EQ(settings.metric, Metric::Euclidean);
}

TEST_F(Tuning, SaysWhatIsMissingBeforeASearch) {
    auto* search = find<QPushButton>("tuning.search");
    EXPECT_FALSE(search->isEnabled());
    EXPECT_TRUE(search->toolTip().contains("reference")) << qPrintable(search->toolTip());
    EXPECT_FALSE(find<QPushButton>("tuning.use")->isEnabled());
}

TEST_F(Tuning, FolderWithoutTrialsIsToldInASentence) {
    files.next = folder.path();
    QTest::mouseClick(find<QPushButton>("tuning.folder"), Qt::LeftButton);
    EXPECT_TRUE(find<QLabel>("tuning.trials")->property("problem").toBool());
    EXPECT_FALSE(find<QLabel>("tuning.trials")->text().isEmpty());
}

TEST_F(Tuning, BestValuesBecomeThoseOfTheInspectionAndCanBeTakenBack) {
    const TuningOutcome outcome = sampleOutcome();
    dialog->showOutcome(outcome);
    saveScreenshot(*dialog, "tuning");
    const CandidateSettings before = controller.state().parameters.candidates;
    QTest::mouseClick(find<QPushButton>("tuning.use"), Qt::LeftButton);
    EXPECT_EQ(controller.state().parameters.candidates, bestCandidateSettings(outcome.result));
    EXPECT_FALSE(find<QPushButton>("tuning.use")->isEnabled());
    controller.undo();
    EXPECT_EQ(controller.state().parameters.candidates, before);
}

TEST_F(Tuning, AnotherCellCanBeChosenAndTheBestOneAgain) {
    const TuningOutcome outcome = sampleOutcome();
    dialog->showOutcome(outcome);
    auto* surface = find<CostSurface>("tuning.surface");
    QTest::mouseClick(surface, Qt::LeftButton, {}, surface->centreOf({29, 19}).toPoint());
    EXPECT_EQ(surface->chosen(), (CostCell{29, 19}));
    QTest::mouseClick(find<QPushButton>("tuning.best"), Qt::LeftButton);
    EXPECT_EQ(surface->chosen(), (CostCell{outcome.result.best.cutoff, outcome.result.best.threshold}));
}

TEST_F(Tuning, OperatingPointLiesOnTheCurveOnceItsValuesAreUsed) {
    const PhotoTuningOutcome tuning = samplePhotos();
    controller.commitCandidates(tuning.inEffect);
    dialog->showOutcome(tuning);
    saveScreenshot(*dialog, "tuning-photos");
    auto* plot = find<RecallPlot>("tuning.plot");
    ASSERT_TRUE(plot->isVisible());
    EXPECT_EQ(plot->inEffect(), (RecallPoint{0.7, 0.6, 15}));
    EXPECT_EQ(plot->chosen(), 1u) << "the fewest photos with the wanted recall";
    QTest::mouseClick(find<QPushButton>("tuning.use"), Qt::LeftButton);
    EXPECT_EQ(controller.state().parameters.candidates, tuning.result.settingsAt({0, 0, 0}));
    EXPECT_EQ(plot->inEffect(), (RecallPoint{0.9, 0.6, 20}));
    controller.undo();
    EXPECT_EQ(plot->inEffect(), (RecallPoint{0.7, 0.6, 15}));
}

TEST_F(Tuning, OperatingPointOfSettingsThatWereNotSearchedIsUnknown) {
    PhotoTuningOutcome tuning = samplePhotos();
    dialog->showOutcome(tuning);
    EXPECT_FALSE(find<RecallPlot>("tuning.plot")->inEffect().has_value());
}

TEST_F(Tuning, RecallOutOfReachIsToldAndTheMostThatCanBeReachedIsChosen) {
    PhotoTuningOutcome tuning = samplePhotos();
    tuning.result.settings.recall = 1.0;
    tuning.result.best.reset();
    dialog->showOutcome(tuning);
    EXPECT_TRUE(find<QLabel>("tuning.stage")->text().contains("100"));
    EXPECT_EQ(find<RecallPlot>("tuning.plot")->chosen(), 1u);
    EXPECT_FALSE(find<QPushButton>("tuning.best")->isEnabled());
}

TEST_F(Tuning, PhotosAreSearchedForWithARecallAndWorldsOnly) {
    auto* objective = find<QComboBox>("tuning.objective");
    EXPECT_FALSE(find<QLineEdit>("tuning.recall")->isVisible());
    objective->setFocus();
    QTest::keyClick(objective, Qt::Key_Down);
    EXPECT_TRUE(find<QLineEdit>("tuning.recall")->isVisible());
    EXPECT_FALSE(find<QLineEdit>("tuning.lambda")->isVisible());
    auto* recall = find<QLineEdit>("tuning.recall");
    recall->clear();
    QTest::keyClicks(recall, "101");
    EXPECT_TRUE(recall->property("invalid").toBool());
    recall->clear();
    QTest::keyClicks(recall, "95");
    EXPECT_FALSE(recall->property("invalid").toBool());
}

}  // namespace
}  // namespace fodscope::test
