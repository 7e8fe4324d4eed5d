// SPDX-License-Identifier: MIT
#include "ui/settings/SettingsDialog.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "core/inspection/ParameterTable.h"
#include "ui/session/FileDialogs.h"
#include "ui/session/InspectionController.h"
#include "ui/settings/ParameterEditor.h"

namespace fodscope::test {
namespace {

class OneFile : public FileDialogs {
  public:
    QString next;
    QString openFile(QWidget*, const QString&, const QString&) override { return next; }
    QStringList openFiles(QWidget*, const QString&, const QString&) override { return {next}; }
    QString saveFile(QWidget*, const QString&, const QString&, const QString&) override { return next; }
    QString chooseFolder(QWidget*, const QString&, const QString&) override { return next; }
};

class Settings : public ::testing::Test {
  protected:
    Settings() {
        controller.createSession(folder.filePath("inspection.fodscope"), newInspectionHeader());
        dialog = std::make_unique<SettingsDialog>(controller, files);
        dialog->show();
    }

    template <typename W>
    W* find(const char* name) {
        W* widget = dialog->findChild<W*>(QString::fromLatin1(name));
        EXPECT_NE(widget, nullptr) << name;
        return widget;
    }
    void type(const char* parameter, const QString& text) {
        auto* line = find<ParameterEditor>(parameter)->findChild<QLineEdit*>();
        ASSERT_NE(line, nullptr);
        line->selectAll();
        QTest::keyClicks(line, text);
    }
    void press(const char* button) { QTest::mouseClick(find<QPushButton>(button), Qt::LeftButton); }

    QTemporaryDir folder;
    OneFile files;
    InspectionController controller;
    std::unique_ptr<SettingsDialog> dialog;
};

TEST_F(Settings, HasAnEditorForEveryParameter) {
    for (const ParameterField& field : parameterTable())
        EXPECT_NE(
            dialog->findChild<ParameterEditor*>(QString::fromStdString("parameter." + field.section + "." + field.key)),
            nullptr)
            << field.section << '.' << field.key;
}

TEST_F(Settings, AppliesWhatWasTypedAndTakesItBack) {
    EXPECT_FALSE(find<QPushButton>("settings.apply")->isEnabled());
    type("parameter.discrepancy.voxel_size_m", "0.03");
    EXPECT_TRUE(find<QLabel>("note.discrepancy.voxel_size_m")->text().contains("0.02"));
    press("settings.apply");
    EXPECT_EQ(controller.state().parameters.discrepancy.voxelSize_m, 0.03);
    EXPECT_FALSE(find<QPushButton>("settings.apply")->isEnabled());
    controller.undo();
    EXPECT_EQ(controller.state().parameters.discrepancy.voxelSize_m, 0.02);
    EXPECT_EQ(find<ParameterEditor>("parameter.discrepancy.voxel_size_m")->text(), "0.02");
}

TEST_F(Settings, WrongValuesAreListedTogetherAndKeepApplyOff) {
    type("parameter.discrepancy.voxel_size_m", "-1");
    type("parameter.denoise.neighbours", "many");
    const QString problems = find<QLabel>("settings.problems")->text();
    EXPECT_TRUE(problems.contains("discrepancy.voxel_size_m")) << qPrintable(problems);
    EXPECT_TRUE(problems.contains("denoise.neighbours")) << qPrintable(problems);
    EXPECT_FALSE(find<QPushButton>("settings.apply")->isEnabled());
    EXPECT_TRUE(find<QPushButton>("settings.apply")->toolTip().contains("wrong"));
    EXPECT_FALSE(find<QPushButton>("settings.save")->isEnabled());
    press("settings.discard");
    EXPECT_TRUE(find<QLabel>("settings.problems")->isHidden());
}

TEST_F(Settings, ResetsARowToThePreset) {
    type("parameter.denoise.neighbours", "20");
    QTest::mouseClick(find<QToolButton>("reset.denoise.neighbours"), Qt::LeftButton);
    EXPECT_EQ(find<ParameterEditor>("parameter.denoise.neighbours")->text(), "50");
    EXPECT_TRUE(find<QToolButton>("reset.denoise.neighbours")->isHidden());
}

TEST_F(Settings, SearchLeavesTheRowsThatMatch) {
    QTest::keyClicks(find<QLineEdit>("settings.search"), "inflation");
    EXPECT_TRUE(find<ParameterEditor>("parameter.cost_map.inflation_radius_m")->isVisible());
    EXPECT_FALSE(find<ParameterEditor>("parameter.denoise.neighbours")->isVisible());
}

TEST_F(Settings, SearchLeavesNoGapsWhereRowsWere) {
    auto* editor = find<ParameterEditor>("parameter.discrepancy.smoothing_passes");
    QTest::keyClicks(find<QLineEdit>("settings.search"), "how often");
    QCoreApplication::sendPostedEvents();
    ASSERT_TRUE(editor->isVisible());
    // A title and one row of two lines; with the gaps of the twelve other rows it would be 400 px.
    EXPECT_LT(editor->parentWidget()->sizeHint().height(), 200);
}

TEST_F(Settings, FileThatWasSavedIsReadBack) {
    type("parameter.denoise.neighbours", "21");
    files.next = folder.filePath("p.yaml");
    press("settings.save");
    ASSERT_TRUE(QFile::exists(files.next));
    press("settings.discard");
    press("settings.load");
    EXPECT_EQ(find<ParameterEditor>("parameter.denoise.neighbours")->text(), "21");
}

TEST_F(Settings, FileWithMistakesIsRefusedWithAllOfThem) {
    files.next = folder.filePath("wrong.yaml");
    QFile file(files.next);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("denoise:\n  neighbors: 3\ndiscrepancy:\n  voxel_size_m: -2\n");
    file.close();
    press("settings.load");
    const QString problems = find<QLabel>("settings.problems")->text();
    EXPECT_TRUE(problems.contains("neighbours")) << qPrintable(problems);
    EXPECT_TRUE(problems.contains("voxel_size_m")) << qPrintable(problems);
    EXPECT_EQ(find<ParameterEditor>("parameter.denoise.neighbours")->text(), "50");
}

}  // namespace
}  // namespace fodscope::test
