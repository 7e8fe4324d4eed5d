// SPDX-License-Identifier: MIT
#include <QBuffer>
#include <QImage>
#include <algorithm>

#include "core/reference/ReferenceMapIo.h"
#include "tests/fakes/SampleInspection.h"
#include "tests/ui/window/WindowFixture.h"

namespace fodscope::test {
namespace {

class Work : public WindowTest {};

std::string picture() {
    QImage image(64, 36, QImage::Format_RGB32);
    image.fill(Qt::darkGray);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    image.save(&buffer, "PNG");
    return bytes.toStdString();
}

int rows(QTableView& table) {
    return table.model()->rowCount();
}

TEST_F(Work, StartsWithThreeChoicesAndNothingElseToDo) {
    EXPECT_TRUE(find("start.new")->isVisible());
    EXPECT_TRUE(find("start.builtin")->isVisible());
    EXPECT_TRUE(find("start.open")->isVisible());
    EXPECT_TRUE(find("status.stop")->isVisible());
    EXPECT_FALSE(find("step.3")->isEnabled());
}

TEST_F(Work, TwoFilesBecomeCandidatesInTheTable) {
    detectRoom();
    auto* table = find<QTableView>("candidate.table");
    EXPECT_GE(rows(*table), 1);
    EXPECT_EQ(rows(*table), static_cast<int>(controller->state().detection->candidates->candidates.size()));
    EXPECT_TRUE(find<QLabel>("map.alignment")->text().contains("aligned"))
        << qPrintable(find<QLabel>("map.alignment")->text());
}

TEST_F(Work, ReferenceWithoutCovarianceIsUsedWithTheEuclideanMetric) {
    detectRoom();
    EXPECT_EQ(controller->state().parameters.candidates.metric, Metric::Euclidean);
    run("metric.mahalanobis");
    ASSERT_TRUE(waitUntilIdle());
    EXPECT_FALSE(banner().isEmpty());
    EXPECT_EQ(controller->state().parameters.candidates.metric, Metric::Euclidean);
    EXPECT_TRUE(find<QPushButton>("button.metric.euclidean")->isChecked());
}

TEST_F(Work, MahalanobisComesBackWithAReferenceThatHasCovariances) {
    detectRoom();
    ASSERT_EQ(controller->state().parameters.candidates.metric, Metric::Euclidean);
    ReferenceMap trained = readReferenceMap(file("reference.ply").toStdString());
    trained.covariance.assign(trained.size(), Eigen::Matrix3d::Identity() * 1e-4);
    trained.untrained.assign(trained.size(), 0);
    writeReferenceMap(file("trained.ply").toStdString(), trained);
    files.next = file("trained.ply");
    run("reference.load");
    ASSERT_TRUE(waitUntilIdle());
    EXPECT_TRUE(banner().isEmpty()) << qPrintable(banner());
    EXPECT_EQ(controller->state().parameters.candidates.metric, Metric::Mahalanobis);
}

TEST_F(Work, EuclideanChosenByTheOperatorStays) {
    detectRoom();
    run("threshold.up");
    ASSERT_TRUE(waitUntilIdle());
    const CandidateSettings chosen = controller->state().parameters.candidates;
    ReferenceMap trained = readReferenceMap(file("reference.ply").toStdString());
    trained.covariance.assign(trained.size(), Eigen::Matrix3d::Identity() * 1e-4);
    trained.untrained.assign(trained.size(), 0);
    writeReferenceMap(file("trained.ply").toStdString(), trained);
    files.next = file("trained.ply");
    run("reference.load");
    ASSERT_TRUE(waitUntilIdle());
    EXPECT_EQ(controller->state().parameters.candidates, chosen);
}

TEST_F(Work, CandidatesFollowTheSliderAndAreKeptWhenItIsLetGo) {
    detectRoom();
    run("step.3");
    const double before = controller->state().parameters.candidates.threshold;
    auto* slider = find("slider.threshold")->findChild<QSlider*>();
    ASSERT_NE(slider, nullptr);
    QSignalSpy shown(controller.get(), &InspectionController::candidatesChanged);
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(slider, Qt::Key_Right);
    ASSERT_TRUE(waitUntilIdle());
    EXPECT_GT(shown.count(), 0);
    EXPECT_GT(controller->state().parameters.candidates.threshold, before);
    EXPECT_FALSE(controller->isPreviewing());
}

TEST_F(Work, MovedThresholdCanBeUndoneAndRedone) {
    detectRoom();
    run("step.3");
    const CandidateSettings before = controller->state().parameters.candidates;
    run("threshold.up");
    ASSERT_TRUE(waitUntilIdle());
    const CandidateSettings moved = controller->state().parameters.candidates;
    ASSERT_NE(moved, before);
    run("edit.undo");
    ASSERT_TRUE(waitUntilIdle());
    EXPECT_EQ(controller->state().parameters.candidates, before);
    run("edit.redo");
    ASSERT_TRUE(waitUntilIdle());
    EXPECT_EQ(controller->state().parameters.candidates, moved);
}

TEST_F(Work, SettingsThatAreAppliedDetectAgainAndCanBeTakenBack) {
    detectRoom();
    const auto before = controller->state().detection->field;
    run("settings.all");
    auto* voxel = find("parameter.discrepancy.voxel_size_m")->findChild<QLineEdit*>();
    ASSERT_NE(voxel, nullptr);
    voxel->selectAll();
    QTest::keyClicks(voxel, "0.04");
    press("settings.apply");
    ASSERT_TRUE(waitUntilIdle());
    EXPECT_EQ(controller->state().detection->parameters.discrepancy.voxelSize_m, 0.04);
    EXPECT_LT(controller->state().detection->field->size(), before->size());
    run("edit.undo");
    ASSERT_TRUE(waitUntilIdle());
    EXPECT_EQ(controller->state().detection->field->size(), before->size());
    EXPECT_TRUE(banner().isEmpty()) << qPrintable(banner());
}

TEST_F(Work, LinkageIsChosenInThePanel) {
    detectRoom();
    run("step.3");
    auto* linkage = find<QComboBox>("candidates.linkage");
    linkage->setCurrentIndex(linkage->findData(static_cast<int>(Linkage::Single)));
    emit linkage->activated(linkage->currentIndex());
    ASSERT_TRUE(waitUntilIdle());
    EXPECT_EQ(controller->state().parameters.candidates.linkage, Linkage::Single);
    run("edit.undo");
    ASSERT_TRUE(waitUntilIdle());
    EXPECT_EQ(controller->state().parameters.candidates.linkage, Linkage::Centroid);
}

TEST_F(Work, ResidualsAreToldAfterTheAlignment) {
    detectRoom();
    ASSERT_TRUE(controller->residuals());
    EXPECT_FALSE(find<QLabel>("map.residuals.sentence")->text().isEmpty());
    run("map.residuals");
    EXPECT_EQ(window->currentStep(), Step::Map);
    run("session.close");
    EXPECT_FALSE(window->commands().find("map.residuals")->isChecked());
    EXPECT_FALSE(window->commands().find("map.residuals")->isEnabled());
}

TEST_F(Work, KnownStartPoseIsUsedUntilItIsForgotten) {
    detectRoom();
    EXPECT_FALSE(window->commands().find("map.register")->isEnabled());
    run("map.start");
    find<QLineEdit>("startPose.x")->setText("0.1");
    find<QLineEdit>("startPose.y")->setText("0");
    find<QLineEdit>("startPose.yaw")->setText("2");
    press("startPose.use");
    ASSERT_TRUE(waitUntilIdle());
    EXPECT_TRUE(controller->hasStartPose());
    EXPECT_TRUE(controller->state().detection->registration.start_T_reference_from_map.has_value());
    EXPECT_NE(controller->state().detection->registration.quality, RegistrationQuality::Bad);
    run("map.register");
    ASSERT_TRUE(waitUntilIdle());
    EXPECT_FALSE(controller->state().detection->registration.start_T_reference_from_map.has_value());
}

TEST_F(Work, HeatMapIsForReferencesWithCovariances) {
    detectRoom();
    EXPECT_FALSE(window->commands().find("reference.heatmap")->isEnabled());
    EXPECT_TRUE(find<QPushButton>("button.reference.heatmap")->toolTip().contains("no covariances"));
    ReferenceMap trained = readReferenceMap(file("reference.ply").toStdString());
    trained.covariance.assign(trained.size(), Eigen::Matrix3d::Identity() * 1e-4);
    trained.untrained.assign(trained.size(), 0);
    trained.untrained.front() = 1;
    writeReferenceMap(file("trained.ply").toStdString(), trained);
    files.next = file("trained.ply");
    run("reference.load");
    ASSERT_TRUE(waitUntilIdle());
    run("reference.heatmap");
    EXPECT_TRUE(find<QPushButton>("button.reference.heatmap")->isChecked());
    EXPECT_TRUE(window->grab().width() > 0);
}

TEST_F(Work, PickedRowIsTheSelectionEverywhere) {
    detectRoom();
    run("step.3");
    auto* table = find<QTableView>("candidate.table");
    const QModelIndex first = table->model()->index(0, 0);
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(first).center());
    EXPECT_EQ(controller->selectedCandidate(), first.data().toString());
    EXPECT_TRUE(find("evidence.candidate")->isVisible());
    controller->selectCandidate(QString());
    EXPECT_TRUE(table->selectionModel()->selectedRows().isEmpty());
}

TEST_F(Work, ReopenedSessionShowsEverythingFromItsFileAlone) {
    detectRoom();
    const auto before = controller->state().detection->candidates->candidates;
    run("step.3");
    QFile::remove(file("reference.ply"));
    QFile::remove(file("map.pcd"));
    restart();
    files.next = file("inspection.fodscope");
    run("session.open");
    ASSERT_TRUE(waitUntilIdle());
    ASSERT_TRUE(controller->isOpen()) << qPrintable(banner());
    EXPECT_TRUE(controller->state().reference);
    ASSERT_TRUE(controller->state().detection);
    const auto& after = controller->state().detection->candidates->candidates;
    ASSERT_EQ(after.size(), before.size());
    EXPECT_EQ(after.front().id, before.front().id);
    EXPECT_EQ(window->currentStep(), Step::Candidates);
    EXPECT_EQ(rows(*find<QTableView>("candidate.table")), static_cast<int>(before.size()));
    // And the slider still works, on the voxels of the session.
    run("threshold.up");
    ASSERT_TRUE(waitUntilIdle());
    EXPECT_TRUE(banner().isEmpty()) << qPrintable(banner());
}

TEST_F(Work, SessionWithPhotosReopensAtTheStepItWasLeftAt) {
    detectRoom();
    const std::string candidate = controller->state().detection->candidates->candidates.front().id;
    emit controller->visits().photoArrived(samplePhoto("W-01", candidate, picture()));
    controller->setProbe({{"Layer", "Map"}});
    run("step.6");
    run("session.close");
    EXPECT_TRUE(controller->probe().empty());
    files.next = file("inspection.fodscope");
    run("session.open");
    ASSERT_TRUE(waitUntilIdle());
    EXPECT_EQ(window->currentStep(), Step::Report);
}

TEST_F(Work, FrontPageOfTheReportIsKept) {
    detectRoom();
    run("step.6");
    auto* ship = find<QLineEdit>("report.ship");
    ship->setFocus();
    QTest::keyClicks(ship, "Testudo");
    QTest::keyClick(ship, Qt::Key_Return);
    EXPECT_EQ(controller->state().header.ship, "Testudo");
}

TEST_F(Work, IssuedReportIsThereInAllForms) {
    detectRoom();
    run("step.6");
    files.next = file("report");
    run("report.issue");
    ASSERT_TRUE(waitUntilIdle());
    EXPECT_TRUE(banner().isEmpty()) << qPrintable(banner());
    for (const char* name : {"report.pdf", "report.html", "report.csv", "report.json"})
        EXPECT_TRUE(QFile::exists(file(QStringLiteral("report/") + name))) << name;
    EXPECT_EQ(controller->state().reports.size(), 1u);
}

TEST_F(Work, ThePlanIsChangedAndTheChangeTakenBack) {
    detectRoom();
    run("step.4");
    controller->setRobotStart({1.0, 0.6, 0.0});
    run("visit.plan");
    ASSERT_TRUE(waitUntilIdle());
    ASSERT_TRUE(banner().isEmpty()) << qPrintable(banner());
    ASSERT_TRUE(controller->state().plan.has_value());
    const std::vector<PlannedStop> stops = controller->stops();
    ASSERT_GE(stops.size(), 1u);
    controller->selectWaypoint(QStringLiteral("W-01"));
    EXPECT_FALSE(controller->selectedCandidate().isEmpty());
    EXPECT_TRUE(find("visit.preview")->isVisible());
    run("visit.remove");
    ASSERT_TRUE(waitUntilIdle());
    EXPECT_EQ(controller->stops().size(), stops.size() - 1);
    EXPECT_TRUE(std::ranges::any_of(controller->state().plan->views,
                                    [](const CandidateView& view) { return view.rest == WaypointStatus::LeftOut; }));
    run("edit.undo");
    EXPECT_EQ(controller->stops().size(), stops.size());
    EXPECT_EQ(controller->stops().front().pose_map, stops.front().pose_map);
    std::vector<PlannedStop> inTheWall = stops;
    inTheWall.front().pose_map.x_m = -50.0;
    controller->changeStops(inTheWall, QStringLiteral("move"));
    ASSERT_TRUE(waitUntilIdle());
    EXPECT_TRUE(banner().contains("outside the grid")) << qPrintable(banner());
    EXPECT_EQ(controller->stops().front().pose_map, stops.front().pose_map);
}

TEST_F(Work, ReaderLabelsByKeyboardAndTakesItBack) {
    controller->setLabeller("Anna");
    detectRoom();
    // A photo, as the robot brings it.
    Photo photo = samplePhoto("W-01", controller->state().detection->candidates->candidates.front().id, picture());
    emit controller->visits().photoArrived(photo);
    ASSERT_EQ(controller->state().photos.size(), 1u);
    run("step.5");
    auto* view = find("labellingView");
    view->setFocus();
    QTest::keyClick(view, Qt::Key_0);
    ASSERT_TRUE(QTest::qWaitFor([this] { return controller->state().decisions.size() == 1; }));
    EXPECT_EQ(controller->state().decisions.front().labels.front().label, kNoFod);
    EXPECT_EQ(controller->state().decisions.front().labeller, "Anna");
    run("edit.undo");
    EXPECT_EQ(lastDecision(controller->state().decisions, "P-001", "Anna"), nullptr);
}

TEST_F(Work, KeysGoThroughStepsAndCandidates) {
    detectRoom();
    QTest::keyClick(window.get(), Qt::Key_3, Qt::ControlModifier);
    EXPECT_EQ(window->currentStep(), Step::Candidates);
    QTest::keyClick(window.get(), Qt::Key_Tab);
    EXPECT_FALSE(controller->selectedCandidate().isEmpty());
    QTest::keyClick(window.get(), Qt::Key_Escape);
    EXPECT_TRUE(controller->selectedCandidate().isEmpty());
    run("help.keys");
    EXPECT_TRUE(find("shortcuts")->isVisible());
    QTest::keyClick(window.get(), Qt::Key_Escape);
    EXPECT_FALSE(find("shortcuts")->isVisible());
    QTest::keyClick(window.get(), Qt::Key_F1);
    EXPECT_TRUE(find("manual")->isVisible());
}

}  // namespace
}  // namespace fodscope::test
