// SPDX-License-Identifier: MIT
#pragma once

#include <QMainWindow>
#include <array>
#include <memory>

#include "ui/commands/Command.h"

class QDockWidget;
class QStackedWidget;

namespace fodscope {

class CandidatesPanel;
class Centre;
class CommandPalette;
class CommandSet;
class ManualWindow;
class SettingsDialog;
class ShortcutsOverlay;
class StartPoseDialog;
class TitleRow;
class Toast;
class TuningDialog;

/// Places the panels as docks round the centre and switches them with the step. What the panels do is theirs.
class MainWindow : public QMainWindow, private Navigation {
    Q_OBJECT

  public:
    /// @param controller, files must outlive the window
    MainWindow(InspectionController& controller, FileDialogs& files, QWidget* parent = nullptr);
    ~MainWindow() override;

    CommandSet& commands() { return *commands_; }
    Step currentStep() const override { return step_; }
    void showStep(Step step) override;

  protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void stepThreshold(int steps, bool coarse) override;
    void askStartPose() override;
    void showResiduals(bool shown) override;
    void showTuning() override;
    void showSettings() override;
    void toggleShortcuts() override;
    void showManual() override;
    void togglePalette() override;
    void toggleTheme() override;
    void fitViews() override;
    void showReferenceHeatMap(bool shown) override;
    void nextUndecidedPhoto() override;
    void leave() override;
    void quit() override;

    void placeTitle();
    void placeDocks();
    void placeStatus();
    QDockWidget* makeDock(const QString& name, const QString& title, QWidget* content, Qt::DockWidgetArea area);
    void followController();
    void takeSession();
    void showDocks();
    void rememberDocks();
    void restorePlaces();

    InspectionController& controller_;
    FileDialogs& files_;
    std::unique_ptr<CommandSet> commands_;
    Step step_ = Step::Reference;
    TitleRow* title_ = nullptr;
    Centre* centre_ = nullptr;
    QStackedWidget* stepPanels_ = nullptr;
    CandidatesPanel* candidatesPanel_ = nullptr;
    QDockWidget* stepDock_ = nullptr;
    QDockWidget* evidenceDock_ = nullptr;
    QDockWidget* tableDock_ = nullptr;
    Toast* toast_ = nullptr;
    ShortcutsOverlay* shortcuts_ = nullptr;
    CommandPalette* palette_ = nullptr;
    /// Made when they are first asked for.
    ManualWindow* manual_ = nullptr;
    SettingsDialog* settings_ = nullptr;
    TuningDialog* tuning_ = nullptr;
    StartPoseDialog* startPose_ = nullptr;
    bool placingDocks_ = false;
    bool followsPhotos_ = false;
};

}  // namespace fodscope
