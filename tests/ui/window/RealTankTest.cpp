// SPDX-License-Identifier: MIT
// A whole inspection of the real tank's simulated survey by hand, from files to the issued report.
#include "core/inspection/GroundTruthLabeller.h"
#include "tests/ui/window/WindowFixture.h"

namespace fodscope::test {
namespace {

QString dataFolder() {
    const QString given = qEnvironmentVariable("FODSCOPE_SHARED_DATA");
    const QString folder = given.isEmpty() ? QStringLiteral(FODSCOPE_RESOURCES "/../../shared/data") : given;
    return folder + QStringLiteral("/nuwc-tank");
}

class RealTank : public WindowTest {
  protected:
    void labelAll() {
        GroundTruthLabeller truth(controller->simulatedWorld(), false);
        controller->setLabeller(QString::fromStdString(truth.name()));
        run("step.5");
        for (const std::string& id : photosWithoutDecision(controller->state())) {
            const PhotoAnswer answer =
                truth.answer(*controller->findPhoto(QString::fromStdString(id)), controller->state().labelSet);
            EXPECT_TRUE(
                controller->decide(QString::fromStdString(id), answer.labels, QString::fromStdString(answer.comment)));
        }
    }
};

TEST_F(RealTank, IsInspectedByHandFromFilesToReport) {
    const QString data = dataFolder();
    if (!QFile::exists(data + "/val_03.pcd")) GTEST_SKIP() << "the survey of the real tank is not at hand";
    // Robots wait for nobody: the drive is as fast as the simulation answers.
    double now_s = 0.0;
    controller->visits().setClock([&] {
        const auto& robot = controller->visits().robotState();
        return now_s += robot && robot->moving ? 2.0 : 0.05;
    });
    files.next = file("tank.fodscope");
    run("session.new");
    for (int i = 0; i < 5; ++i)
        files.nextFiles << QStringLiteral("%1/train_%2.pcd").arg(data).arg(i, 2, 10, QLatin1Char('0'));
    run("reference.nominal");
    ASSERT_TRUE(waitUntilIdle()) << qPrintable(banner());
    ASSERT_TRUE(controller->state().reference) << qPrintable(banner());
    files.next = data + "/val_03.pcd";
    run("map.load");
    ASSERT_TRUE(waitUntilIdle());
    ASSERT_TRUE(controller->state().detection && controller->state().detection->candidates) << qPrintable(banner());
    EXPECT_FALSE(controller->state().detection->candidates->candidates.empty());
    files.next = data + "/val_03.yaml";
    run("visit.grid");
    files.next = data + "/worlds/val_03.json";
    run("robot.world");
    ASSERT_TRUE(waitUntilIdle());
    ASSERT_TRUE(QTest::qWaitFor([this] { return controller->robotStart().has_value(); })) << qPrintable(banner());
    run("visit.plan");
    ASSERT_TRUE(waitUntilIdle());
    ASSERT_TRUE(controller->state().plan) << qPrintable(banner());
    run("visit.start");
    ASSERT_TRUE(
        QTest::qWaitFor([this] { return controller->visits().runnerState() == RunnerState::Finished; }, 240000));
    ASSERT_FALSE(controller->state().photos.empty());
    labelAll();
    EXPECT_TRUE(photosWithoutDecision(controller->state()).empty());
    run("step.6");
    files.next = file("report");
    run("report.issue");
    ASSERT_TRUE(waitUntilIdle());
    EXPECT_TRUE(QFile::exists(file("report/report.pdf"))) << qPrintable(banner());
    EXPECT_TRUE(banner().isEmpty()) << qPrintable(banner());
}

}  // namespace
}  // namespace fodscope::test
