// SPDX-License-Identifier: MIT
#include "tests/ui/window/WindowFixture.h"

#include <QApplication>

#include "core/cloud/PointCloudIo.h"
#include "ui/panels/MessageBanner.h"

namespace fodscope::test {
namespace {

constexpr int kPatience_ms = 240000;
constexpr double kSpacing_m = 0.02;

/// A plate of points from `corner` along two edges.
void addPlate(PointCloud& cloud, const Eigen::Vector3d& corner, const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
    const int columns = static_cast<int>(u.norm() / kSpacing_m);
    const int rows = static_cast<int>(v.norm() / kSpacing_m);
    for (int i = 0; i <= columns; ++i)
        for (int j = 0; j <= rows; ++j)
            cloud.points.emplace_back(corner + u * (static_cast<double>(i) / columns) +
                                      v * (static_cast<double>(j) / rows));
}

}  // namespace

WindowTest::WindowTest() {
    QSettings().clear();
    restart();
}

WindowTest::~WindowTest() {
    window.reset();
    controller.reset();
}

void WindowTest::restart() {
    window.reset();
    controller = std::make_unique<InspectionController>();
    window = std::make_unique<MainWindow>(*controller, files);
    window->resize(1366, 768);
    window->show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    // Keys go to the active window; without a window manager nobody else makes it that.
    QApplication::setActiveWindow(window.get());
}

bool WindowTest::waitUntilIdle() {
    return QTest::qWaitFor([this] { return !controller->tasks().isBusy(); }, kPatience_ms);
}

QString WindowTest::banner() {
    return find<MessageBanner>("banner")->message();
}

void WindowTest::write(const QString& name, const QByteArray& bytes) {
    QFile target(file(name));
    ASSERT_TRUE(target.open(QIODevice::WriteOnly));
    target.write(bytes);
}

void WindowTest::writeRoom(const QString& name, bool withBox) {
    PointCloud cloud;
    using V = Eigen::Vector3d;
    addPlate(cloud, V(0, 0, 0), V(2, 0, 0), V(0, 2, 0));
    addPlate(cloud, V(0, 0, 0), V(2, 0, 0), V(0, 0, 1));
    addPlate(cloud, V(0, 0, 0), V(0, 2, 0), V(0, 0, 1));
    addPlate(cloud, V(2, 0, 0), V(0, 2, 0), V(0, 0, 0.7));
    // A step in one corner, so that the room looks the same from one side only.
    addPlate(cloud, V(1.4, 1.4, 0.3), V(0.6, 0, 0), V(0, 0.6, 0));
    if (withBox) {
        for (const double z : {0.08, 0.14, 0.2})
            addPlate(cloud, V(0.7, 0.8, z), V(0.2, 0, 0), V(0, 0.16, 0));
    }
    writePointCloud(file(name).toStdString(), cloud);
}

void WindowTest::detectRoom() {
    writeRoom("reference.ply", false);
    writeRoom("map.pcd", true);
    files.next = file("inspection.fodscope");
    run("session.new");
    ASSERT_TRUE(controller->isOpen()) << qPrintable(banner());
    files.next = file("reference.ply");
    run("reference.load");
    ASSERT_TRUE(waitUntilIdle());
    files.next = file("map.pcd");
    run("map.load");
    ASSERT_TRUE(waitUntilIdle());
    ASSERT_TRUE(controller->state().detection && controller->state().detection->candidates) << qPrintable(banner());
}

}  // namespace fodscope::test
