// SPDX-License-Identifier: MIT
#include "core/cloud/PointCloudIo.h"
#include "tests/ui/window/WindowFixture.h"

namespace fodscope::test {
namespace {

/// Whatever a file holds, the window says in one sentence what is wrong, and stays as it was.
class BadInput : public WindowTest {
  protected:
    void open() {
        files.next = file("inspection.fodscope");
        run("session.new");
        ASSERT_TRUE(controller->isOpen());
    }

    void expectRefused(const QString& name) {
        files.next = file(name);
        run("reference.load");
        ASSERT_TRUE(waitUntilIdle());
        EXPECT_TRUE(banner().contains(name)) << qPrintable(banner());
        EXPECT_TRUE(banner().contains(';')) << qPrintable(banner());
        EXPECT_FALSE(controller->state().reference);
        EXPECT_TRUE(window->isVisible());
    }
};

TEST_F(BadInput, MissingFile) {
    open();
    expectRefused("nowhere.pcd");
}

TEST_F(BadInput, EmptyFile) {
    open();
    write("empty.pcd", "");
    expectRefused("empty.pcd");
}

TEST_F(BadInput, TruncatedFile) {
    open();
    writeRoom("room.ply", false);
    QFile room(file("room.ply"));
    ASSERT_TRUE(room.open(QIODevice::ReadOnly));
    write("truncated.ply", room.read(room.size() / 2));
    expectRefused("truncated.ply");
}

TEST_F(BadInput, NoCloudAtAll) {
    open();
    write("letter.pcd", "Dear Sir or Madam,\n");
    expectRefused("letter.pcd");
}

TEST_F(BadInput, NothingButNotANumber) {
    open();
    write("nan.pcd",
          "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n"
          "nan nan nan\nnan nan nan\n");
    expectRefused("nan.pcd");
}

TEST_F(BadInput, MillimetresInsteadOfMetres) {
    open();
    writeRoom("room.ply", false);
    PointCloud cloud = readPointCloud(file("room.ply").toStdString());
    for (Eigen::Vector3d& point : cloud.points)
        point *= 1000.0;
    writePointCloud(file("millimetres.pcd").toStdString(), cloud);
    expectRefused("millimetres.pcd");
}

TEST_F(BadInput, OnePoint) {
    open();
    PointCloud cloud;
    cloud.points.emplace_back(1.0, 2.0, 3.0);
    writePointCloud(file("one.pcd").toStdString(), cloud);
    expectRefused("one.pcd");
}

TEST_F(BadInput, MapThatDoesNotOverlapClaimsNoCandidates) {
    open();
    writeRoom("reference.ply", false);
    files.next = file("reference.ply");
    run("reference.load");
    ASSERT_TRUE(waitUntilIdle());
    PointCloud line;
    for (int i = 0; i < 4000; ++i)
        line.points.emplace_back(0.01 * i, 3.0 * std::sin(0.01 * i), 2.0 * std::cos(0.03 * i));
    writePointCloud(file("elsewhere.pcd").toStdString(), line);
    files.next = file("elsewhere.pcd");
    run("map.load");
    ASSERT_TRUE(waitUntilIdle());
    EXPECT_FALSE(controller->shownCandidates());
    run("step.2");
    EXPECT_TRUE(find("map.remedy")->isVisible() || !banner().isEmpty());
}

TEST_F(BadInput, NoSessionFile) {
    write("other.fodscope", "this is no database");
    files.next = file("other.fodscope");
    run("session.open");
    ASSERT_TRUE(waitUntilIdle());
    EXPECT_TRUE(banner().contains("other.fodscope")) << qPrintable(banner());
    EXPECT_FALSE(controller->isOpen());
    EXPECT_TRUE(find("start.new")->isVisible());
}

TEST_F(BadInput, SessionWhereNothingMayBeWritten) {
    files.next = file("no/such/folder/inspection.fodscope");
    run("session.new");
    EXPECT_FALSE(banner().isEmpty());
    EXPECT_FALSE(controller->isOpen());
}

TEST_F(BadInput, ErrorCanBeDismissed) {
    open();
    expectRefused("nowhere.pcd");
    QTest::keyClick(window.get(), Qt::Key_Escape);
    EXPECT_TRUE(banner().isEmpty());
}

}  // namespace
}  // namespace fodscope::test
