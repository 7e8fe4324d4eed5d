// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>
#include <string>
#include <vector>

#include "ui/settings/ParameterDraft.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QScrollArea;

namespace fodscope {

class Card;
class FileDialogs;
class InspectionController;
class SettingsRow;

/// All parameters of the inspection, section by section, made from the parameter table alone. What is typed takes
/// effect with Apply; until then nothing changes. Blocks nothing: the window and STOP stay at hand.
class SettingsDialog : public QDialog {
    Q_OBJECT

  public:
    /// @param controller, files must outlive the dialog
    SettingsDialog(InspectionController& controller, FileDialogs& files, QWidget* parent = nullptr);
    ~SettingsDialog() override;

    /// Scrolls to a section.
    void showSection(const std::string& section);

  private:
    QWidget* makeTop();
    QWidget* makeSections();
    QWidget* makeBottom();
    Card* makeCard(const std::string& section, QWidget* parent);
    void takeInspection();
    void refresh();
    void filter();
    void choosePreset();
    void load();
    void save();
    void apply();

    InspectionController& controller_;
    FileDialogs& files_;
    ParameterDraft draft_;
    QString told_;
    QComboBox* preset_ = nullptr;
    QPushButton* usePreset_ = nullptr;
    QLineEdit* search_ = nullptr;
    QListWidget* index_ = nullptr;
    QScrollArea* scroll_ = nullptr;
    QLabel* nothingFound_ = nullptr;
    QLabel* frozen_ = nullptr;
    QLabel* problems_ = nullptr;
    QPushButton* save_ = nullptr;
    QPushButton* discard_ = nullptr;
    QPushButton* apply_ = nullptr;
    std::vector<SettingsRow*> rows_;
    std::vector<std::pair<std::string, Card*>> cards_;
};

}  // namespace fodscope
