// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QSlider>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "ui/commands/CommandSet.h"
#include "ui/session/InspectionController.h"
#include "ui/window/MainWindow.h"

namespace fodscope::test {

/// Answers file dialogs with what a test put in.
class PreparedFiles : public FileDialogs {
  public:
    QString next;
    QStringList nextFiles;

    QString openFile(QWidget*, const QString&, const QString&) override { return next; }
    QStringList openFiles(QWidget*, const QString&, const QString&) override { return nextFiles; }
    QString saveFile(QWidget*, const QString&, const QString&, const QString&) override { return next; }
    QString chooseFolder(QWidget*, const QString&, const QString&) override { return next; }
};

/// The window as a person has it before them, with settings and folders of its own.
class WindowTest : public ::testing::Test {
  protected:
    WindowTest();
    ~WindowTest() override;

    /// Closes the window and the inspection and starts anew, as after a restart of the program.
    void restart();

    template <typename W = QWidget>
    W* find(const char* name) {
        W* widget = window->findChild<W*>(QString::fromLatin1(name));
        EXPECT_NE(widget, nullptr) << name;
        return widget;
    }
    void run(const char* command) { window->commands().find(QString::fromLatin1(command))->trigger(); }
    void press(const char* button) { QTest::mouseClick(find<QPushButton>(button), Qt::LeftButton); }
    bool waitUntilIdle();
    QString banner();
    QString file(const QString& name) const { return folder.filePath(name); }
    void write(const QString& name, const QByteArray& bytes);

    /// A room of 2 × 2 × 1 m, sampled every 2 cm; with a box on its floor when asked for.
    void writeRoom(const QString& name, bool withBox);
    /// A new session with the empty room as reference and the room with a box as map, detected.
    void detectRoom();

    QTemporaryDir folder;
    PreparedFiles files;
    std::unique_ptr<InspectionController> controller;
    std::unique_ptr<MainWindow> window;
};

}  // namespace fodscope::test
